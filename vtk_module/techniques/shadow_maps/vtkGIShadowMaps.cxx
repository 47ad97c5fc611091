// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIShadowMaps.h"

#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "shadows/ShadowCasters.h"
#include "technique/FrameBuilder.h"
#include "techniques/shadow_maps/ShadowPlan.h"

#include "vtkOpenGLRenderer.h"
#include "vtkRenderWindow.h"

#include <map>
#include <tuple>

vtkStandardNewMacro(vtkGIShadowMaps);

using namespace penumbra;

namespace
{
constexpr const char* Atlas = "shadow-maps.atlas";

// Margin in texels: hardware filtering reads the neighbours of the outermost sample, too.
constexpr double HardwareMargin = 2.0;

// Radius in texels and number of samples of a filter that hides the dither pattern with which partly transparent
// casters are drawn. It is also at least one pixel wide.
constexpr double PatternRadius = 2.5;
constexpr int PatternSamples = 16;

using TileKey = std::tuple<int, int, int>;

// A texel of the atlas that is fixed in the world, because directional views move by whole texels. The dither
// pattern of partly transparent casters starts there.
glm::ivec2 Anchor(const ShadowMap& map)
{
  glm::ivec2 anchor(map.Tile.X, map.Tile.Y);
  if (map.View.Parallel)
  {
    anchor += glm::ivec2(glm::mod(
      glm::round(glm::dvec2(map.View.WorldToView[3]) / map.View.Texel), glm::dvec2(4096.0)));
  }
  return anchor;
}

// Shader variant for the lights of a plan.
Defines VariantOf(const ShadowPlan& plan)
{
  Defines variant;
  for (const auto& light : plan.LightData)
  {
    if (light.Size.x > 0.0f)
    {
      variant["GI_SOFT"] = "1";
    }
    if (light.Size.y > GI_OUTLINE_ROUND)
    {
      variant["GI_FLAT"] = "1";
    }
    if (light.Maps.z != GI_SHADOW_SINGLE)
    {
      variant[light.Maps.z == GI_SHADOW_CUBE ? "GI_CUBE" : "GI_CASCADES"] = "1";
    }
  }
  return variant;
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

/// Signatures of the casters and maps that a view's atlas holds.
struct vtkGIShadowMaps::AtlasContents
{
  std::vector<double> Casters;
  std::map<TileKey, std::vector<double>> Tiles;
};

struct vtkGIShadowMaps::Resources
{
  Buffer MapBlock;
  Buffer LightBlock;
  std::shared_ptr<ShadowPlan> Plan;
  double Radius = 0.0;            ///< radius of the filter in texels
  int Samples = 1;                ///< number of samples of the filter
  bool PartialCoverage = false;   ///< some casters are partly transparent
  const History* Atlas = nullptr; ///< atlas of the last view that was drawn
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

bool vtkGIShadowMaps::UpdatePlan(FrameBuilder& frame)
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
  this->Impl->PartialCoverage = frame.Capture().CastsPartialShadows();
  const bool dithered = this->FilterRadius > 0.0 && this->Impl->PartialCoverage;
  this->Impl->Radius = dithered ? std::max(this->FilterRadius, PatternRadius) : this->FilterRadius;
  this->Impl->Samples =
    dithered ? std::max(this->FilterSamples, PatternSamples) : this->FilterSamples;
  options.Margin = this->Impl->Radius + HardwareMargin;
  const double texels = static_cast<double>(this->Memory) * (1 << 20) / sizeof(float);
  const double tilesAcross = widest / options.Resolution;
  options.Squares =
    std::min(texels / options.Resolution / options.Resolution, tilesAcross * tilesAcross);
  options.Cascades = this->Cascades;
  options.Logarithmic = this->SplitBlend;
  options.LightTangent = std::tan(glm::radians(0.5 * this->LightAngle));
  options.LightRadius = this->LightRadius;

  const LightTable::Shadowed shadowed = frame.Lights().AssignMask(this->MaximumLights);
  this->Impl->Plan = std::make_shared<ShadowPlan>(
    PlanShadows(frame.Lights(), shadowed.With, frame.GetView(), options));
  this->ShadowedLights = static_cast<int>(this->Impl->Plan->LightData.size());
  const std::vector<ShadowMap>& maps = this->Impl->Plan->Maps;
  this->TexelWidth = maps.empty() ? 0.0 : maps.front().View.Texel;
  for (std::size_t i = this->ShadowedLights; i < shadowed.With.size(); ++i)
  {
    frame.Lights().Lights()[shadowed.With[i]].MaskChannel = -1;
  }
  const int withoutSpace = static_cast<int>(shadowed.With.size()) - this->ShadowedLights;
  this->UnshadowedLights = shadowed.Without + withoutSpace;
  if (this->UnshadowedLights > 0)
  {
    frame.AddNote(std::to_string(this->UnshadowedLights) + " of " +
      std::to_string(this->UnshadowedLights + this->ShadowedLights) +
      " lights cast no shadow: raise shadow-maps." +
      (withoutSpace > 0 ? "memory" : "maximum-lights") + " for more.");
  }
  return this->ShadowedLights > 0;
}

const char* vtkGIShadowMaps::GetOfferedResource()
{
  return resource::DirectVisibility;
}

void vtkGIShadowMaps::Contribute(FrameBuilder& frame)
{
  if (!this->UpdatePlan(frame))
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
    // Reading the depth orders this pass after the capture, which updates the casters.
    .Read(resource::Depth)
    .Execute([this, &scene, &atlas, &contents = frame.ViewState<AtlasContents>(this)](
               FrameContext& context) { this->DrawMaps(context, scene, atlas, contents); });
  frame.AddPass("shadow-mask")
    .Read(resource::Depth)
    .Read(resource::DepthCopy)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::Facet)
    .ReadHistory(atlas, "atlas")
    .Write(resource::DirectVisibility, frame.WindowTexture(GL_RGBA8, layers))
    .Offer(this->FilterArguments(false))
    .Execute([variant = VariantOf(plan), layers, lights = this->ShadowedLights](
               FrameContext& context) { DrawMask(context, variant, layers, lights); });
}

void vtkGIShadowMaps::DrawMaps(
  FrameContext& context, SceneCapture& scene, const History& atlas, AtlasContents& contents)
{
  const ShadowPlan& plan = *this->Impl->Plan;
  AtlasContents drawn;
  this->DrawnMaps = 0;
  const bool redrawAll =
    !atlas.Written || this->AlwaysRedraw || contents.Casters != CasterSignature(scene);
  for (const auto& map : plan.Maps)
  {
    const TileKey key(map.Tile.X, map.Tile.Y, map.Tile.Size);
    std::vector<double> signature = map.Signature();
    const auto found = contents.Tiles.find(key);
    if (redrawAll || found == contents.Tiles.end() || found->second != signature)
    {
      DrawShadowMap(context, scene, atlas.Storage, map.View, map.Tile, Anchor(map));
      ++this->DrawnMaps;
    }
    drawn.Tiles[key] = std::move(signature);
  }
  if (context.Renderer()->GetRenderWindow()->GetAbortRender())
  {
    contents = AtlasContents(); // maps may lack casters
    return;
  }
  // After drawing, because drawing updates pipelines.
  drawn.Casters = CasterSignature(scene);
  // Tiles that are no longer used are dropped, because others may be drawn over them.
  contents = std::move(drawn);
}

Arguments vtkGIShadowMaps::FilterArguments(bool volume)
{
  // Volumes add up many points along each ray, so one sample per point is enough.
  const bool filters = this->Impl->Radius > 0.0 && !volume;
  return Arguments()
    .Block("ShadowMapBlock", this->Impl->MapBlock)
    .Block("ShadowLightBlock", this->Impl->LightBlock)
    .Set("bias", glm::vec3(this->ConstantBias, this->SlopeBias, this->NormalBias))
    .Set("filterRadius", filters ? this->Impl->Radius : 0.0)
    .Set("pixelRadius", filters && this->Impl->PartialCoverage ? 1.0 : 0.0)
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
  visibility.InVolumes.erase("GI_FLAT");
  visibility.Textures = 1;
  visibility.Bind = [this](ForwardProgram& program) {
    program.Set(this->FilterArguments(program.IsOfVolume()));
    program.SetTexture("atlas", this->Impl->Atlas->Storage.Get());
  };
  frame.ShadeForward(std::move(visibility));
}
