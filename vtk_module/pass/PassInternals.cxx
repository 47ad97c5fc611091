// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/PassInternals.h"

#include "base/Matrices.h"
#include "capture/CameraOverride.h"
#include "capture/VisibleSky.h"
#include "gpu/BoundFramebuffer.h"
#include "light/DirectLight.h"
#include "pass/TechniqueChoice.h"
#include "technique/FrameBuilder.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkTextureObject.h"

#include <stdexcept>

using namespace penumbra;

vtkGIPass::Internals::Internals()
  : Techniques(CreateTechniques())
{
  for (auto& technique : this->Techniques)
  {
    technique->SetViews(this);
  }
  this->Forward->SetShaders(&this->Shaders);
  this->Guard->SetFree([this] { this->FreeResources(); });
}

vtkGIPass::Internals::~Internals()
{
  this->Guard->Leave();
  for (auto& technique : this->Techniques)
  {
    technique->SetViews(nullptr); // users may keep the technique
  }
}

const vtkGIPass::Internals::ViewRecord* vtkGIPass::Internals::FindRecord(
  vtkRenderer* renderer) const
{
  for (const auto& view : this->Views)
  {
    if (renderer && view.second.Renderer == renderer)
    {
      return &view.second;
    }
  }
  return nullptr;
}

const ViewState* vtkGIPass::Internals::FindView(vtkRenderer* renderer) const
{
  const ViewRecord* record = this->FindRecord(renderer);
  return record ? &record->States : nullptr;
}

void vtkGIPass::Internals::Restart()
{
  ++this->Restarts; // also applies to views that do not exist yet
}

vtkGIPass::Internals::ViewRecord& vtkGIPass::Internals::FindOrAddRecord(vtkRenderer* renderer)
{
  ViewRecord& record = this->Views[{ renderer, renderer->GetActiveCamera()->GetLeftEye() }];
  if (!record.Renderer)
  {
    // A new view, or a new renderer at the address of a deleted one.
    this->ForgetView({ renderer, renderer->GetActiveCamera()->GetLeftEye() });
    record = ViewRecord();
    record.Renderer = renderer;
    record.Name = std::to_string(++this->ViewCount);
  }
  return record;
}

bool vtkGIPass::Internals::ShowTile(
  const vtkRenderState* state, bool join, const WholePicture::Draw& draw)
{
  vtkRenderer* renderer = state->GetRenderer();
  if (join && !renderer->GetSelector() && WholePicture::IsTile(renderer))
  {
    return this->FindOrAddRecord(renderer).Whole.Show(state, draw);
  }
  for (auto& view : this->Views)
  {
    if (view.first.first == renderer)
    {
      view.second.Whole = WholePicture();
    }
  }
  return false;
}

std::string vtkGIPass::Internals::CheckContext()
{
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 43)
  {
    return "global illumination needs OpenGL 4.3, and this window has " + std::to_string(major) +
      "." + std::to_string(minor) +
      "; use a newer driver, or software rendering (PENUMBRA_BACKEND=egl or osmesa).";
  }
  return "";
}

namespace
{
// Format of the bound depth buffer, so that depth can be copied; 0 if it cannot be.
GLenum BoundDepthFormat()
{
  const TextureDesc desc = { BoundFormat(GL_DEPTH_ATTACHMENT), 0, 0, 0 };
  return desc.IsDepth() ? desc.Format : 0;
}
}

View vtkGIPass::Internals::MakeView(vtkOpenGLRenderer* renderer, ViewRecord& record)
{
  View view;
  const int* size = renderer->GetRenderWindow()->GetActualSize();
  renderer->GetTiledSizeAndOrigin(
    &view.Viewport.z, &view.Viewport.w, &view.Viewport.x, &view.Viewport.y);
  // A picture that is larger than the window is drawn to a framebuffer of the picture's size.
  view.WindowSize = { std::max(size[0], view.Viewport.x + view.Viewport.z),
    std::max(size[1], view.Viewport.y + view.Viewport.w) };
  view.WorldToView = CameraOverride::WorldToView(renderer);
  view.ViewToWorld = glm::inverse(view.WorldToView);
  view.ViewToClip = CameraOverride::ViewToClip(renderer);
  view.Parallel = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  view.DepthFormat = BoundDepthFormat();
  view.WantsAntiAliasing = renderer->GetRenderWindow()->GetMultiSamples() > 1;
  renderer->ComputeVisiblePropBounds(view.Bounds.data());
  if (view.Bounds[0] <= view.Bounds[1])
  {
    view.Diagonal = glm::length(glm::dvec3(view.Bounds[1] - view.Bounds[0],
      view.Bounds[3] - view.Bounds[2], view.Bounds[5] - view.Bounds[4]));
  }
  const SceneSignature signature = this->Sign(renderer, view);
  view.Changes = signature.ChangesSince(record.Signature);
  record.StillFrames = view.Changes.Any ? 0 : record.StillFrames;
  view.StillFrames = record.StillFrames;
  view.Sequence = record.StillFrames;
  view.FrameNumber = record.FrameNumber;
  view.FirstFrame = record.FirstFrame;
  return view;
}

SceneSignature vtkGIPass::Internals::Sign(vtkOpenGLRenderer* renderer, const View& view)
{
  vtkMTimeType time = 0;
  for (auto& technique : this->Techniques)
  {
    time = std::max(time, technique->GetMTime());
  }
  return SceneSignature::Of(renderer, view, time, this->Placeholder);
}

std::string vtkGIPass::Internals::RenderFrame(vtkGIPass* self, const vtkRenderState* state)
{
  auto* renderer = static_cast<vtkOpenGLRenderer*>(state->GetRenderer());
  this->CapturedProps = 0;
  std::string problem = this->CheckContext();
  if (!problem.empty())
  {
    return problem;
  }
  ViewRecord& record = this->FindOrAddRecord(renderer);
  const bool standsAlone = record.Restarts != this->Restarts;
  if (standsAlone)
  {
    record.Restarts = this->Restarts;
    record.StillFrames = 0;
    record.FirstFrame = record.FrameNumber;
    record.Motion = MotionTable(); // nothing is reprojected from earlier frames
  }
  this->BeginTimes(record,
    self->GetCollectStatistics() || self->CurrentFrameBudget(renderer->GetRenderWindow()) > 0.0);
  try
  {
    if (this->ShaderPath != this->Shaders.OverrideFolder() || this->ShadersInvalid)
    {
      this->ShadersInvalid = true;
      this->Shaders.SetOverrideFolder(this->ShaderPath);
      this->Capture.ReloadShaders();
      this->Forward->ReloadShaders();
      this->ShadersInvalid = false;
    }
    const bool complete = this->DrawFrame(self, state, record, standsAlone);
    record.StillFrames = complete ? record.StillFrames + 1 : 0;
    ++record.FrameNumber;
  }
  catch (const std::exception& error)
  {
    problem = error.what();
    this->Timed = nullptr;
    record.Budget.Ignore(record.FrameNumber);
    // Techniques may have counted work that was not done.
    this->Pool.ForgetView(record.Name);
    record.States = ViewState();
    record.Motion = MotionTable();
  }
  this->Pool.EndFrame(record.Name);
  for (auto it = this->Views.begin(); it != this->Views.end();)
  {
    if (it->second.Renderer)
    {
      ++it;
      continue;
    }
    this->LastTimed = this->LastTimed == &it->second ? nullptr : this->LastTimed;
    this->ForgetView(it->first);
    it = this->Views.erase(it);
  }
  return problem;
}

void vtkGIPass::Internals::ForgetView(const ViewKey& key)
{
  this->Pool.ForgetView(this->Views[key].Name);
  if (!this->FindRecord(key.first))
  {
    this->RayScenes.erase(key.first);
  }
}

void vtkGIPass::Internals::SkipFrame(vtkRenderer* renderer)
{
  for (auto& view : this->Views)
  {
    if (view.second.Renderer == renderer)
    {
      view.second.RadianceKept = false;
    }
  }
}

namespace
{
// A texture of VTK. nullptr if it cannot be sampled, because it is multisampled.
std::unique_ptr<Texture> Borrow(vtkTextureObject* texture)
{
  if (!texture || texture->GetTarget() != GL_TEXTURE_2D)
  {
    return nullptr;
  }
  const int width = static_cast<int>(texture->GetWidth());
  const int height = static_cast<int>(texture->GetHeight());
  return std::make_unique<Texture>(Texture::Borrow(texture->GetHandle(),
    { TextureFormat(texture->GetTarget(), texture->GetHandle()), width, height, 0 }));
}

// The bound framebuffer, whose textures are known if it is the window's own. ownDepth: whether passes need depths that VTK
// must not see.
WindowTarget BoundWindow(vtkOpenGLRenderWindow* window, bool ownDepth)
{
  vtkOpenGLFramebufferObject* framebuffer = window->GetRenderFramebuffer();
  WindowTarget target;
  target.Framebuffer = BoundFramebuffer();
  if (target.Framebuffer == framebuffer->GetFBOIndex() && window->GetMultiSamples() <= 1)
  {
    target.Color = Borrow(framebuffer->GetColorAttachmentAsTextureObject(0));
    target.Depth = Borrow(framebuffer->GetDepthAttachmentAsTextureObject());
    target.OwnDepth = ownDepth;
  }
  return target;
}
}

bool vtkGIPass::Internals::DrawFrame(
  vtkGIPass* self, const vtkRenderState* state, ViewRecord& record, bool standsAlone)
{
  auto* renderer = static_cast<vtkOpenGLRenderer*>(state->GetRenderer());
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  View view = this->MakeView(renderer, record);
  view.KeepsRadiance = self->GetKeepRadiance();
  view.StandsAlone = standsAlone;
  this->ApplyBudget(self, renderer, record, view);
  this->Capture.Collect(state);
  this->Lights.Collect(renderer);

  const View unshifted = view;
  FrameGraph graph;
  RayProps& rays = this->RayScenes[renderer];
  LightingPlan plan;
  FrameBuilder builder(graph, view, this->Lights, this->Capture, rays, record.Motion, record.States,
    plan, renderer, this->Pool, record.Name);
  for (auto& technique : this->Techniques)
  {
    technique->SetTookPart(false);
  }
  if (const int count = this->Lights.MisshapenLights())
  {
    builder.AddNote("The shape of " + std::to_string(count) +
      " lights has no effect: angles are for directional lights, spheres, discs and rectangles for "
      "positional ones, "
      "and headlights have no shape.");
  }
  bool lit = false;
  const std::vector<vtkGITechnique*> chosen = ChooseTechniques(this->Techniques, builder, plan);
  rays.SetRules(plan.Rules());
  this->Capture.SetRules(plan.Rules());
  for (vtkGITechnique* technique : chosen)
  {
    technique->SetTookPart(true);
    builder.AddFor(technique->GetName(), technique->GetShaderParameters());
    technique->Contribute(builder);
    lit |= technique->ChangesLight();
  }
  builder.AddFor({}, {});
  this->Capture.SetMendsNormals(lit);
  this->DrawnByRays = plan.IsDrawnByRays() ? &rays : nullptr;
  ContributeIndirectLight(builder, builder.GetIndirectLights());
  if (!builder.GetIndirectLights().empty())
  {
    this->Placeholder.Add(renderer);
  }
  this->Capture.Contribute(builder, !this->Lights.Lights().empty());
  ContributeSky(builder, this->Capture.Skies());
  ContributeBackdrop(builder);
  const bool ambientLight = plan.SpreadShare() > 0.0 || !builder.GetIndirectLights().empty() ||
    this->Capture.MayHaveAmbient();
  ContributeDirectLight(builder, this->Lights, this->Capture.Materials(),
    { this->Capture.IsExtended(), self->GetKeepRadiance(), builder.WantsLitRadiance(),
      plan.HasLitParts(), ambientLight, plan.SpreadShare(), plan.Interreflection(), plan.Rules(),
      builder.GetDirectDisplay() });
  record.RadianceKept = false;
  if (self->GetKeepRadiance())
  {
    this->KeepRadiance(builder);
  }
  if (self->CurrentFrameBudget(window) > 0.0 && !record.Budget.Problem().empty())
  {
    builder.AddNote(record.Budget.Problem());
  }
  builder.AddLastPasses();
  this->Notes.clear();
  for (const auto& note : builder.GetNotes())
  {
    this->Notes += (this->Notes.empty() ? "" : "\n") + note;
  }
  ContributePresentation(builder, this->Capture.Materials());
  graph.Compile();
  this->Lights.Upload();

  const WindowTarget target = BoundWindow(window, this->Capture.HasSurfaces());
  FrameExecutor executor(
    this->Pool, this->Shaders, view, renderer, target, this->Held, record.Name, this->ViewBlock);
  const int skies = DrawSkies(renderer, this->Capture.Skies());
  GpuTimer* timer = this->Timed ? &*record.Timer : nullptr;
  if (timer)
  {
    timer->Mark("frame-setup");
  }
  executor.Run(graph, timer);
  record.RadianceKept = self->GetKeepRadiance();
  this->CapturedProps = this->Capture.CapturedProps() + skies + this->Capture.DrawOthers(renderer);
  this->Forward->SetLights(this->Lights, builder.GetForwardLight());
  FrameStatistics& statistics = record.Statistics;
  statistics.Textures = static_cast<int>(this->Pool.Count());
  statistics.Bytes = this->Pool.Bytes();
  statistics.Lights = this->Lights.Lights().size();
  statistics.Frames = view.StillFrames + 1;
  if (window->GetAbortRender())
  {
    record.Budget.Ignore(record.FrameNumber);
    return false; // the next frame is compared with the last complete one
  }
  // The signature is taken after drawing, because drawing updates pipelines and lights.
  record.Signature = this->Sign(renderer, unshifted);
  return true;
}

void vtkGIPass::Internals::KeepRadiance(FrameBuilder& frame)
{
  const glm::ivec2& size = frame.GetView().WindowSize;
  frame.AddPass("keep-radiance")
    .Read(resource::Radiance)
    .Read(resource::Albedo)
    .ReadIfPresent(resource::Sky, "GI_VISIBLE_SKY")
    .WriteHistory(frame.Keep(resource::Radiance, frame.WindowTexture(GL_RGBA32F)), "kept")
    .SideEffect()
    .Compute("lib/keep_radiance.comp", {}, {}, Work::Items(size.x, size.y));
}

bool vtkGIPass::Internals::ReadHistory(
  vtkRenderer* renderer, const std::string& name, vtkImageData* image)
{
  const ViewRecord* record = this->FindRecord(renderer);
  const Texture* texture = record ? this->Pool.FindHistory(record->Name, name) : nullptr;
  const bool readable = texture && texture->Target() == GL_TEXTURE_2D &&
    (texture->Desc().Format == GL_RGBA32F || texture->Desc().Format == GL_RGBA16F);
  if (!readable || !image || !this->Guard->Window())
  {
    return false;
  }
  this->Guard->Window()->MakeCurrent();
  image->SetDimensions(texture->Desc().Width, texture->Desc().Height, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  glBindTexture(GL_TEXTURE_2D, texture->Get());
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, image->GetScalarPointer());
  glBindTexture(GL_TEXTURE_2D, 0);
  return true;
}

bool vtkGIPass::Internals::ReadRadiance(vtkRenderer* renderer, vtkImageData* image)
{
  const ViewRecord* record = this->FindRecord(renderer);
  return record && record->RadianceKept && this->ReadHistory(renderer, resource::Radiance, image);
}

void vtkGIPass::Internals::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window || window == this->Guard->Window())
  {
    this->Guard->Leave();
  }
}

void vtkGIPass::Internals::FreeResources()
{
  this->PutSettingsBack();
  this->Timed = nullptr;
  this->LastTimed = nullptr;
  for (auto& technique : this->Techniques)
  {
    technique->ReleaseGraphicsResources(this->Guard->Window());
  }
  this->FxaaFilter->ReleaseGraphicsResources();
  this->Pool.Clear();
  this->Shaders.Release();
  this->Lights.ReleaseGraphicsResources();
  this->Capture.Materials().ReleaseGraphicsResources();
  this->ViewBlock = Buffer();
  this->DrawnByRays = nullptr;
  this->RayScenes.clear();
  for (auto& [key, record] : this->Views)
  {
    ViewRecord cleared;
    cleared.Renderer = record.Renderer;
    cleared.Name = record.Name;
    cleared.Restarts = record.Restarts;
    record = std::move(cleared);
  }
}
