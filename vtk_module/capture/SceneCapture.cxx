// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/SceneCapture.h"

#include "base/Matrices.h"
#include "base/ScopeExit.h"
#include "capture/CameraOverride.h"
#include "capture/CaptureHooks.h"
#include "capture/MotionTable.h"
#include "capture/PropTraits.h"
#include "capture/VisibleSky.h"
#include "gpu/ScopedState.h"
#include "graph/Frame.h"

#include "rays/SurfaceRules.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkTexture.h"
#include "vtkTextureUnitManager.h"

namespace penumbra
{
SceneCapture::SceneCapture(const ShaderLibrary& shaders)
  : Hooks(vtkSmartPointer<vtkGICaptureHooks>::New())
{
  this->Hooks->SetTables(&this->Table, &shaders);
}

SceneCapture::~SceneCapture() = default;

void SceneCapture::ReloadShaders()
{
  this->Hooks->CheckSnippets();
  this->Hooks->RebuildShaders();
}

void SceneCapture::Collect(const vtkRenderState* state)
{
  this->Captured.clear();
  this->Others.clear();
  this->SkyProps.clear();
  this->CasterProps.clear();
  this->Surfaces.clear();
  this->Table.Clear();
  this->SetMotion(nullptr);
  bool extended = false;
  bool part = false;
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    const bool captured = CanCapture(prop);
    (captured ? this->Captured : (IsSky(prop) ? this->SkyProps : this->Others)).push_back(prop);
    extended |= captured && NeedsExtended(prop);
    part |= captured && MayHavePartialCoverage(prop);
  }
  // VTK culls the list above to the view, but props outside of it still cast shadows into it.
  vtkPropCollection* props = state->GetRenderer()->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility() && CanCapture(prop))
    {
      this->CasterProps.push_back(prop);
    }
  }
  this->Table.SetPartialCoverage(part);
  this->HasEnvironment = state->GetRenderer()->GetUseImageBasedLighting();
  this->HasAmbient = std::any_of(this->Captured.begin(), this->Captured.end(),
    [this](vtkProp* prop) { return penumbra::MayHaveAmbient(prop, this->HasEnvironment); });
  this->Outputs = CaptureOutputs();
  this->Outputs.Extended = extended;
}

bool SceneCapture::HasPBR() const
{
  return std::any_of(this->Captured.begin(), this->Captured.end(), IsPBR);
}

bool SceneCapture::Reflects(double share) const
{
  return std::any_of(this->Captured.begin(), this->Captured.end(),
    [share](vtkProp* prop) { return ReflectsShare(prop, share); });
}

bool SceneCapture::CastsPartialShadows() const
{
  const auto translucent = [](vtkTexture* texture) { return texture && texture->IsTranslucent(); };
  return std::any_of(this->CasterProps.begin(), this->CasterProps.end(), [&](vtkProp* prop) {
    // VTK does not check the alpha of actors that are forced opaque, or of PBR base colour textures.
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkProperty* property = actor ? actor->GetProperty() : nullptr;
    return prop->HasTranslucentPolygonalGeometry() ||
      (property && translucent(property->GetTexture("albedoTex"))) ||
      (property && actor->GetForceOpaque() &&
        (property->GetOpacity() < 1.0 || translucent(actor->GetTexture())));
  });
}

void SceneCapture::SetMendsNormals(bool mends)
{
  this->Hooks->SetMendsNormals(mends);
}

void SceneCapture::SetRules(const SurfaceRules& rules)
{
  this->Hooks->SetRules(rules);
}

void SceneCapture::SetMotion(MotionTable* motion)
{
  this->Motion = motion;
  this->Hooks->SetMotion(motion);
}

void SceneCapture::Contribute(Frame& frame, bool hasLights)
{
  // Without lights VTK shows unlit colours, and fragments that cover a pixel partly keep theirs.
  this->Outputs.Ambient = !hasLights || this->Table.HasPartialCoverage() || this->HasAmbient;
  if (this->Motion && this->Motion->Deform(this->CasterProps))
  {
    this->Outputs.Request(resource::Displacement);
  }
  this->Hooks->SetOutputs(this->Outputs);
  // Eight bits suffice for VTK's eight-bit framebuffer. PBR is encoded for display later, so
  // its linear values need more.
  auto& pass = frame.AddPass("capture");
  const GLenum reflectance = this->Outputs.Extended ? GL_RGBA16 : GL_RGBA8;
  // Blended fragments are rounded to the window's eight bits, as in VTK.
  const bool wide =
    this->Outputs.Extended || (frame.GetView().KeepsRadiance && !this->Table.HasPartialCoverage());
  const GLenum depth = frame.GetView().DepthFormat;
  pass.Write(resource::Depth, frame.WindowTexture(depth ? depth : GL_DEPTH_COMPONENT32F))
    .Write(resource::Albedo, frame.WindowTexture(reflectance))
    .Write(resource::Normal, frame.WindowTexture(GL_RGBA16))
    .Write(resource::DepthCopy, frame.WindowTexture(depth ? depth : GL_DEPTH_COMPONENT32F));
  if (this->Outputs.Ambient)
  {
    pass.Write(resource::Ambient, frame.WindowTexture(wide ? GL_RGBA16F : GL_RGBA8));
  }
  if (this->Outputs.Extended)
  {
    pass.Write(resource::Surface, frame.WindowTexture(GL_RGBA16))
      .Write(resource::Emission, frame.WindowTexture(GL_RGBA16F));
  }
  for (const CaptureOutputs::Optional* optional : this->Outputs.RequestedTargets())
  {
    pass.Write(optional->Resource, frame.WindowTexture(optional->Format));
  }
  pass.SideEffect().Execute([this](FrameContext& context) { this->Draw(context); });
}

void SceneCapture::Draw(FrameContext& context)
{
  const std::vector<const char*> outputs = this->Outputs.Resources();
  ScopedState scope(context.State());
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const auto window = static_cast<unsigned int>(bound);
  context.BindTarget(outputs, resource::Depth);
  scope.Set(GL_BLEND, this->Table.HasPartialCoverage());
  if (this->Table.HasPartialCoverage())
  {
    context.State()->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthMask(true);
  // Where nothing is captured, only the albedo's alpha is read. Blending reads all targets.
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLint cleared = this->Table.HasPartialCoverage() ? static_cast<GLint>(outputs.size()) : 1;
  for (GLint output = 0; output < cleared; ++output)
  {
    glClearBufferfv(GL_COLOR, output, nothing);
  }
  if (!context.Output(resource::Depth)->IsBorrowed())
  {
    // Our own depth buffer starts with the window's depth, which other layers may have drawn.
    const GLfloat far = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &far);
  }
  if (!context.Output(resource::Depth)->IsBorrowed() && context.GetView().DepthFormat)
  {
    context.State()->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, window);
    const glm::ivec4& area = context.GetView().Viewport;
    glBlitFramebuffer(area.x, area.y, area.x + area.z, area.y + area.w, area.x, area.y,
      area.x + area.z, area.y + area.w, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  }
  const View& view = context.GetView();
  this->Hooks->SetParallel(view.Parallel);
  this->Hooks->SetDepthWindow(glm::vec2(view.DepthWindow));
  CameraOverride camera(context.Renderer(), view.WorldToView, view.ViewToClip);
  this->CapturedPropCount = this->DrawProps(context.Renderer(), this->Captured, false);
  this->Table.Upload();
  if (this->Motion)
  {
    this->Motion->Upload();
  }

  // A depth buffer must not be bound and read at the same time. Techniques test against the original and read the
  // copy.
  context.CopyDepth(context.Output(resource::Depth), context.Output(resource::DepthCopy));
  if (this->HasSurfaces())
  {
    this->DrawSurfaces(context);
  }
}

void SceneCapture::DrawSurfaces(FrameContext& context)
{
  ScopedState scope(context.State());
  context.BindTarget(this->Outputs.Resources(), resource::Depth);
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthFunc(GL_LESS);
  scope.DepthMask(true);
  for (const Surface& surface : this->Surfaces)
  {
    context.DrawBound(surface.Shader, this->Outputs.SnippetDefines(),
      Arguments(surface.Given).Sample("depthTexture", context.Output(resource::DepthCopy)),
      surface.Outline);
    context.CopyDepth(context.Output(resource::Depth), context.Output(resource::DepthCopy));
  }
}

int SceneCapture::DrawProps(
  vtkOpenGLRenderer* renderer, std::vector<vtkProp*>& props, bool translucent)
{
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  this->Hooks->Attach(&state);
  const ScopeExit detach([&] { this->Hooks->Detach(&state); });
  vtkTextureUnitManager* units =
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetTextureUnitManager();
  const int unit = units->Allocate();
  const ScopeExit free([&] { units->Free(unit); });
  this->Hooks->SetTextureUnit(unit, renderer);
  int drawn = 0;
  int layer = 0;
  for (vtkProp* prop : props)
  {
    if (renderer->GetRenderWindow()->GetAbortRender())
    {
      break;
    }
    this->Hooks->SetLayer(layer++);
    drawn += prop->RenderOpaqueGeometry(renderer);
    if (translucent && prop->HasTranslucentPolygonalGeometry())
    {
      // Translucent actors do not write depth unless this key is set.
      vtkInformation* keys = prop->GetPropertyKeys();
      keys->Set(vtkOpenGLActor::GLDepthMaskOverride(), 1);
      drawn += prop->RenderTranslucentPolygonalGeometry(renderer);
      keys->Remove(vtkOpenGLActor::GLDepthMaskOverride());
    }
  }
  return drawn;
}

void SceneCapture::DrawCasters(vtkOpenGLRenderer* renderer, const glm::dmat4& worldToView,
  const glm::dmat4& viewToClip, bool parallel, const glm::ivec2& anchor)
{
  CameraOverride camera(renderer, worldToView, viewToClip);
  this->Hooks->SetParallel(parallel);
  this->Hooks->SetCasting(true, anchor);
  this->Hooks->SetDepthWindow({ 0.0f, 1.0f });
  const ScopeExit capture([&] { this->Hooks->SetCasting(false, anchor); });
  this->DrawProps(renderer, this->CasterProps, true);
}

int SceneCapture::DrawOthers(vtkOpenGLRenderer* renderer)
{
  int drawn = 0;
  for (vtkProp* prop : this->Others)
  {
    drawn += prop->RenderOpaqueGeometry(renderer);
  }
  return drawn;
}
}
