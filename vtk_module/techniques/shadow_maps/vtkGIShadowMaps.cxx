// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIShadowMaps.h"

#include "capture/ChangeTimes.h"
#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"
#include "techniques/shadow_maps/ShadowPlan.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"

#include <cstdint>
#include <map>
#include <tuple>

vtkStandardNewMacro(vtkGIShadowMaps);

using namespace penumbra;

namespace
{
constexpr const char* Atlas = "shadow-maps.atlas";

// In texels: a filter reads the neighbours of its outermost place as well.
constexpr double HardwareMargin = 2.0;

// A filter of so many texels, no narrower than a pixel, and of so many samples hides the pattern by which
// casters that cover in part are drawn.
constexpr double PatternRadius = 2.5;
constexpr int PatternSamples = 16;

using TileKey = std::tuple<int, int, int>;
/// What an atlas shows: of which casters, and each of its squares.
struct Shown
{
  std::vector<double> Casters;
  std::map<TileKey, std::vector<double>> Squares;
};

// When a prop or one of its parts moved or changed last.
vtkMTimeType CastTime(vtkProp* prop)
{
  vtkMTimeType time = prop->GetRedrawMTime();
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    time = std::max(time, part->GetRedrawMTime());
    if (auto* actor = vtkActor::SafeDownCast(part))
    {
      time = std::max(time, LookTime(actor));
    }
  }
  return time;
}

// The casters and when they changed last, as numbers.
std::vector<double> SignCasters(const SceneCapture& scene)
{
  std::vector<double> signature;
  for (vtkProp* prop : scene.Casters())
  {
    signature.push_back(static_cast<double>(CastTime(prop)));
    signature.push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop)));
  }
  return signature;
}

// The texel of the atlas that stands for a place fixed in the world: what a directional light's maps
// show moves by whole texels.
glm::ivec2 Anchor(const ShadowMap& map)
{
  glm::ivec2 anchor(map.Tile.X, map.Tile.Y);
  if (map.Shown.Parallel)
  {
    anchor += glm::ivec2(glm::mod(
      glm::round(glm::dvec2(map.Shown.WorldToView[3]) / map.Shown.Texel), glm::dvec2(4096.0)));
  }
  return anchor;
}

// What the lights of a plan need of the shaders.
Defines VariantOf(const ShadowPlan& plan)
{
  Defines variant;
  for (const auto& light : plan.LightData)
  {
    if (light.Size.x > 0.0f)
    {
      variant["GI_SOFT"] = "1";
    }
    if (light.Maps.z != GI_SHADOW_SINGLE)
    {
      variant[light.Maps.z == GI_SHADOW_CUBE ? "GI_CUBE" : "GI_CASCADES"] = "1";
    }
  }
  return variant;
}

void DrawMap(FrameContext& context, SceneCapture& scene, const Texture& atlas, const ShadowMap& map)
{
  ScopedState scope(context.State());
  context.BindTarget({}, { &atlas, -1 });
  scope.Viewport(map.Tile.X, map.Tile.Y, map.Tile.Size, map.Tile.Size);
  scope.Set(GL_SCISSOR_TEST, true);
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthFunc(GL_LEQUAL);
  scope.DepthMask(true);
  const GLfloat far = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &far);
  // Depths hold all casters; one that a rounding puts before them casts all the same.
  glEnable(GL_DEPTH_CLAMP);
  scene.DrawCasters(context.Renderer(), map.Shown.WorldToView, map.Shown.ViewToClip,
    map.Shown.Parallel, Anchor(map));
  glDisable(GL_DEPTH_CLAMP);
}
}

struct vtkGIShadowMaps::Resources
{
  Buffer MapBlock;
  Buffer LightBlock;
  std::map<const Texture*, Shown> Drawn; ///< by atlas: each view has its own
  std::shared_ptr<ShadowPlan> Plan;
  double Radius = 0.0; ///< of the filter, in texels
  int Samples = 1;     ///< of the filter
  bool InPart = false; ///< casters may cover in part
  GLuint Atlas = 0;    ///< of the view that was drawn last
};

vtkGIShadowMaps::vtkGIShadowMaps()
  : Impl(new Resources)
{
}

vtkGIShadowMaps::~vtkGIShadowMaps() = default;

void vtkGIShadowMaps::ReleaseGraphicsResources(vtkWindow*)
{
  *this->Impl = Resources();
}

bool vtkGIShadowMaps::MakePlan(FrameBuilder& frame)
{
  this->ShadowedLights = 0;
  this->UnshadowedLights = 0;
  this->TexelWidth = 0.0;
  if (frame.GetView().Diagonal <= 0.0)
  {
    return false;
  }
  GLint widest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &widest);
  ShadowOptions options;
  options.Resolution = std::min(this->Resolution, static_cast<int>(widest));
  this->Impl->InPart = frame.Capture().CastsInPart();
  const bool patterned = this->FilterRadius > 0.0 && this->Impl->InPart;
  this->Impl->Radius = patterned ? std::max(this->FilterRadius, PatternRadius) : this->FilterRadius;
  this->Impl->Samples =
    patterned ? std::max(this->FilterSamples, PatternSamples) : this->FilterSamples;
  options.Margin = this->Impl->Radius + HardwareMargin;
  const double texels = static_cast<double>(this->Memory) * (1 << 20) / sizeof(float);
  const double along = widest / options.Resolution;
  options.Squares = std::min(texels / options.Resolution / options.Resolution, along * along);
  options.Cascades = this->Cascades;
  options.Logarithmic = this->SplitBlend;
  options.LightTangent = std::tan(glm::radians(0.5 * this->LightAngle));
  options.LightRadius = this->LightRadius;

  const LightTable::Shadowed shadowed = frame.Lights().AssignMask(this->MaximumLights);
  this->Impl->Plan = std::make_shared<ShadowPlan>(
    PlanShadows(frame.Lights(), shadowed.With, frame.GetView(), options));
  this->ShadowedLights = static_cast<int>(this->Impl->Plan->LightData.size());
  const std::vector<ShadowMap>& maps = this->Impl->Plan->Maps;
  this->TexelWidth = maps.empty() ? 0.0 : maps.front().Shown.Texel;
  for (std::size_t i = this->ShadowedLights; i < shadowed.With.size(); ++i)
  {
    frame.Lights().Lights()[shadowed.With[i]].MaskChannel = -1;
  }
  const int homeless = static_cast<int>(shadowed.With.size()) - this->ShadowedLights;
  this->UnshadowedLights = shadowed.Without + homeless;
  if (this->UnshadowedLights > 0)
  {
    frame.AddNote(std::to_string(this->UnshadowedLights) + " of " +
      std::to_string(this->UnshadowedLights + this->ShadowedLights) +
      " lights cast no shadow: raise shadow-maps." + (homeless > 0 ? "memory" : "maximum-lights") +
      " for more.");
  }
  return this->ShadowedLights > 0;
}

const char* vtkGIShadowMaps::GetOfferedResource()
{
  return resource::DirectVisibility;
}

void vtkGIShadowMaps::Contribute(FrameBuilder& frame)
{
  if (!this->MakePlan(frame))
  {
    return;
  }
  SceneCapture& scene = frame.Capture();
  scene.Request(resource::Facet);
  this->ShadeForward(frame);
  const int layers = (this->ShadowedLights + 3) / 4;
  frame.AddPass("shadow-maps")
    .Read(resource::Depth)
    .Read(resource::WindowDepth)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::Facet)
    .Write(resource::DirectVisibility, frame.WindowTexture(GL_RGBA8, layers))
    .Execute([this, &scene, layers](FrameContext& context) {
      const Texture& atlas = this->DrawMaps(context, scene);
      this->DrawMask(context, atlas, layers);
    });
}

const Texture& vtkGIShadowMaps::DrawMaps(FrameContext& context, SceneCapture& scene)
{
  const ShadowPlan& plan = *this->Impl->Plan;
  bool fresh = false;
  const Texture& atlas =
    context.History(Atlas, { GL_DEPTH_COMPONENT32F, plan.Width, plan.Height, 0 }, fresh);
  this->Impl->Atlas = atlas.Get();
  Shown& before = this->Impl->Drawn[&atlas];
  Shown now;
  this->DrawnMaps = 0;
  const bool stale = fresh || this->AlwaysRedraw || before.Casters != SignCasters(scene);
  for (const auto& map : plan.Maps)
  {
    const TileKey key(map.Tile.X, map.Tile.Y, map.Tile.Size);
    std::vector<double> signature = map.Signature();
    const auto found = before.Squares.find(key);
    if (stale || found == before.Squares.end() || found->second != signature)
    {
      DrawMap(context, scene, atlas, map);
      ++this->DrawnMaps;
    }
    now.Squares[key] = std::move(signature);
  }
  // Signed after drawing, as that brings pipelines up to date.
  now.Casters = SignCasters(scene);
  // Squares that are no longer used are forgotten: others may be drawn over them.
  before = std::move(now);
  return atlas;
}

void vtkGIShadowMaps::BindFilter(const Program& program, bool volume)
{
  const auto whole = [&program](
                       const char* name, int value) { glUniform1i(program.Location(name), value); };
  const auto real = [&program](const char* name, double value) {
    glUniform1f(program.Location(name), static_cast<GLfloat>(value));
  };
  this->Impl->MapBlock.BindBase(GL_SHADER_STORAGE_BUFFER, 2);
  this->Impl->LightBlock.BindBase(GL_SHADER_STORAGE_BUFFER, 3);
  glUniform3f(program.Location("bias"), static_cast<GLfloat>(this->ConstantBias),
    static_cast<GLfloat>(this->SlopeBias), static_cast<GLfloat>(this->NormalBias));
  whole("receiverPlane", this->ReceiverPlane);
  // Volumes add up many places along each ray: there one sample each is enough.
  const bool filters = this->Impl->Radius > 0.0 && !volume;
  real("filterRadius", filters ? this->Impl->Radius : 0.0);
  real("pixelRadius", filters && this->Impl->InPart ? 1.0 : 0.0);
  whole("filterSamples", filters ? this->Impl->Samples : 1);
  whole("blockerSamples", this->BlockerSamples);
  whole("penumbraSamples", this->PenumbraSamples);
}

void vtkGIShadowMaps::DrawMask(FrameContext& context, const Texture& atlas, int layers)
{
  const ShadowPlan& plan = *this->Impl->Plan;
  this->Impl->MapBlock.Upload(
    GL_SHADER_STORAGE_BUFFER, plan.MapData.data(), plan.MapData.size() * sizeof(plan.MapData[0]));
  this->Impl->LightBlock.Upload(GL_SHADER_STORAGE_BUFFER, plan.LightData.data(),
    plan.LightData.size() * sizeof(plan.LightData[0]));
  const Program& program = context.Shaders().Fragment("shadow_maps/mask.frag", VariantOf(plan));
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthFunc(GL_GREATER);
  scope.DepthMask(false);
  for (int layer = 0; layer < layers; ++layer)
  {
    context.BindTarget({ { context.Output(resource::DirectVisibility), layer } },
      { context.Input(resource::Depth), -1 });
    context.Use(program,
      { context.Input(resource::WindowDepth), context.Input(resource::Albedo),
        context.Input(resource::Normal), context.Input(resource::Facet), &atlas });
    this->BindFilter(program, false);
    glUniform1i(program.Location("firstLight"), layer * 4);
    glUniform1i(program.Location("lightCount"),
      std::min(4, static_cast<int>(plan.LightData.size()) - layer * 4));
    context.DrawFullscreen();
  }
}

void vtkGIShadowMaps::ShadeForward(FrameBuilder& frame)
{
  ForwardPart visibility;
  visibility.Source = "shadow_maps/forward.glsl";
  visibility.OnSurfaces = VariantOf(*this->Impl->Plan);
  visibility.InVolumes = visibility.OnSurfaces;
  visibility.InVolumes.erase("GI_SOFT");
  visibility.Textures = 1;
  visibility.Bind = [this](ForwardProgram& program) {
    this->BindFilter(program, program.IsOfVolume());
    program.SetTexture("atlas", this->Impl->Atlas);
  };
  frame.ShadeForward(std::move(visibility));
}
