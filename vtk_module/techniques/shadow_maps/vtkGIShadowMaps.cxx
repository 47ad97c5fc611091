// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIShadowMaps.h"

#include "base/ScopeExit.h"
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
      time = std::max(time, AppearanceTime(actor));
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
  glEnable(GL_DEPTH_CLAMP); // which VTK's cache does not know
  const ScopeExit unclamp([] { glDisable(GL_DEPTH_CLAMP); });
  scene.DrawCasters(context.Renderer(), map.Shown.WorldToView, map.Shown.ViewToClip,
    map.Shown.Parallel, Anchor(map));
}

void DrawMask(FrameContext& context, const Defines& variant, int layers, int lights)
{
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthFunc(GL_GREATER);
  scope.DepthMask(false);
  for (int layer = 0; layer < layers; ++layer)
  {
    context.BindTarget({ { context.Output(resource::DirectVisibility), layer } },
      { context.Input(resource::Depth), -1 });
    context.DrawBound("shadow_maps/mask.frag", variant,
      Arguments().Set("firstLight", layer * 4).Set("lightCount", std::min(4, lights - layer * 4)));
  }
}
}

/// What a view's atlas shows: of which casters, and each of its squares.
struct vtkGIShadowMaps::ShownSquares
{
  std::vector<double> Casters;
  std::map<TileKey, std::vector<double>> Squares;
};

struct vtkGIShadowMaps::Resources
{
  Buffer MapBlock;
  Buffer LightBlock;
  std::shared_ptr<ShadowPlan> Plan;
  double Radius = 0.0; ///< of the filter, in texels
  int Samples = 1;     ///< of the filter
  bool InPart = false; ///< casters may cover in part
  const History* Atlas = nullptr; ///< of the view that was drawn last
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
  this->Impl->InPart = frame.Capture().CastsPartialShadows();
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
  const ShadowPlan& plan = *this->Impl->Plan;
  History& atlas = frame.Keep(Atlas, { GL_DEPTH_COMPONENT32F, plan.Width, plan.Height, 0 });
  this->Impl->Atlas = &atlas;
  this->ShadeForward(frame);
  this->Impl->MapBlock.Upload(
    GL_SHADER_STORAGE_BUFFER, plan.MapData.data(), plan.MapData.size() * sizeof(plan.MapData[0]));
  this->Impl->LightBlock.Upload(GL_SHADER_STORAGE_BUFFER, plan.LightData.data(),
    plan.LightData.size() * sizeof(plan.LightData[0]));
  const int layers = (this->ShadowedLights + 3) / 4;
  frame.AddPass("shadow-maps")
    .UpdateHistory(atlas)
    // Casters are those of the capture, which brings them up to date.
    .Read(resource::Depth)
    .Execute([this, &scene, &atlas, &shown = frame.ViewState<ShownSquares>(this)](
               FrameContext& context) { this->DrawMaps(context, scene, atlas, shown); });
  frame.AddPass("shadow-mask")
    .Read(resource::Depth)
    .Read(resource::DepthCopy)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::Facet)
    .ReadHistory(atlas, "atlas")
    .Write(resource::DirectVisibility, frame.WindowTexture(GL_RGBA8, layers))
    .Offer(this->FilterArguments(false))
    .Execute([variant = VariantOf(plan), layers,
               lights = this->ShadowedLights](FrameContext& context) {
      DrawMask(context, variant, layers, lights);
    });
}

void vtkGIShadowMaps::DrawMaps(
  FrameContext& context, SceneCapture& scene, const History& atlas, ShownSquares& before)
{
  const ShadowPlan& plan = *this->Impl->Plan;
  ShownSquares now;
  this->DrawnMaps = 0;
  const bool stale =
    !atlas.Written || this->AlwaysRedraw || before.Casters != SignCasters(scene);
  for (const auto& map : plan.Maps)
  {
    const TileKey key(map.Tile.X, map.Tile.Y, map.Tile.Size);
    std::vector<double> signature = map.Signature();
    const auto found = before.Squares.find(key);
    if (stale || found == before.Squares.end() || found->second != signature)
    {
      DrawMap(context, scene, atlas.Storage, map);
      ++this->DrawnMaps;
    }
    now.Squares[key] = std::move(signature);
  }
  // Signed after drawing, as that brings pipelines up to date.
  now.Casters = SignCasters(scene);
  // Squares that are no longer used are forgotten: others may be drawn over them.
  before = std::move(now);
}

Arguments vtkGIShadowMaps::FilterArguments(bool volume)
{
  // Volumes add up many places along each ray: there one sample each is enough.
  const bool filters = this->Impl->Radius > 0.0 && !volume;
  return Arguments()
    .Block("ShadowMapBlock", this->Impl->MapBlock)
    .Block("ShadowLightBlock", this->Impl->LightBlock)
    .Set("bias", glm::vec3(this->ConstantBias, this->SlopeBias, this->NormalBias))
    .Set("filterRadius", filters ? this->Impl->Radius : 0.0)
    .Set("pixelRadius", filters && this->Impl->InPart ? 1.0 : 0.0)
    .Set("filterSamples", filters ? this->Impl->Samples : 1)
    .Set("blockerSamples", this->BlockerSamples)
    .Set("penumbraSamples", this->PenumbraSamples)
    .Set("receiverPlane", this->ReceiverPlane);
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
    program.Set(this->FilterArguments(program.IsOfVolume()));
    program.SetTexture("atlas", this->Impl->Atlas->Storage.Get());
  };
  frame.ShadeForward(std::move(visibility));
}
