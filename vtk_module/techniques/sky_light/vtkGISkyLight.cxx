// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGISkyLight.h"

#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"
#include "techniques/sky_light/SkyMaps.h"

#include "vtkOpenGLRenderer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkGISkyLight);

using namespace penumbra;

namespace
{
constexpr const char* Atlas = "sky-light.atlas";
constexpr const char* Raw = "sky-light.raw";
constexpr const char* Filtered = "sky-light.filtered";

// The maps are divided into this many parts, one for each pixel of a block of 4 x 4.
constexpr int BlockWidth = 4;
constexpr int Parts = BlockWidth * BlockWidth;
// Number of a still frame from which on pixels need no light of their neighbours, as each has looked up every part.
constexpr int OwnFrames = Parts;

// Number of still frames that draw as many cells into new maps as all maps may have.
constexpr double RenewingFrames = 8.0;

// Numbers of maps that translucent surfaces and volumes look up at each point, without neighbours to help.
constexpr int SurfaceLookups = 32;
constexpr int VolumeLookups = 16;
// Length in texels of a map over which light varies in a volume.
constexpr double GrainTexels = 16.0;

// Pixel of the block that looks up a part. Four parts that follow each other are in a block of 2 x 2.
glm::ivec2 PixelOfPart(int part)
{
  return { (part & 1) | (part >> 1 & 2), (part >> 1 & 1) | (part >> 2 & 2) };
}

// Directions are too few below this number: their shadows are seen one by one.
constexpr int FewestMaps = 64;

int WholeParts(double maps)
{
  return static_cast<int>(std::ceil(maps / Parts)) * Parts;
}

// A share of a number of maps, at least one of them.
int ShareOf(int maps, double share)
{
  return std::min(maps, std::max(1, static_cast<int>(maps * share)));
}

bool HasEnvironment(vtkRenderer* renderer)
{
  return renderer->GetUseImageBasedLighting() && renderer->GetEnvironmentTexture();
}
}

/// The sky and the maps of one view.
struct vtkGISkyLight::ViewLight
{
  SkyDirections Sky;
  SkyMaps Maps;
  History* Atlas = nullptr; ///< of the current frame
  bool SkyChanged = true;
  int MapCount = Parts;   ///< number of maps when all are drawn
  int LastAveraged = -2;  ///< number of the last frame whose samples were kept
  int AveragedFrames = 0; ///< number of frames in the kept mean
};

// The pixels that look up the sky: one in each block of Stride x Stride. They are sorted into a tile for each part of the
// maps, so that a draw of a tile needs one part only.
struct vtkGISkyLight::Grid
{
  int Stride;
  glm::ivec2 Size;
  glm::ivec2 Tile;

  Grid(const View& view, int stride)
    : Stride(stride)
    , Size((glm::ivec2(view.Viewport.z, view.Viewport.w) + stride - 1) / stride)
    , Tile((this->Size + BlockWidth - 1) / BlockWidth)
  {
  }
  TextureDesc Texels(GLenum format) const
  {
    return { format, BlockWidth * this->Tile.x, BlockWidth * this->Tile.y, 0 };
  }
  Defines Variant() const { return { { "GI_STRIDE", std::to_string(this->Stride) } }; }
  penumbra::Arguments Arguments() const
  {
    return penumbra::Arguments().Set("gridSize", this->Size).Set("gridTile", this->Tile);
  }
  void Filter(FrameContext& context) const
  {
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, false);
    context.BindTarget({ Filtered });
    scope.Viewport(0, 0, this->Size.x, this->Size.y);
    context.DrawBound("sky_light/filter.frag", this->Variant(), this->Arguments());
  }
};

void vtkGISkyLight::LookUp(FrameContext& context, const ViewLight& light, const Grid& grid,
  int lookups, const Texture& target)
{
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, false);
  context.BindTarget({ { &target, -1 } }, {});
  Defines variant = grid.Variant();
  variant["GI_LOOKUPS"] = std::to_string(lookups);
  if (light.AveragedFrames > 1)
  {
    variant["GI_CONTINUED"] = "1";
  }
  Arguments arguments = grid.Arguments();
  arguments.Add(context.GetView().ToScene(light.Maps.Center()))
    .Set("fieldHalf", 0.5 * this->MapSize);
  for (int part = 0; part < Parts; ++part)
  {
    const glm::ivec2 place = PixelOfPart(part);
    const glm::ivec2 corner = place * grid.Tile;
    scope.Viewport(corner.x, corner.y, grid.Tile.x, grid.Tile.y);
    // Another part in each frame, so that still pixels look up all of them.
    const int turned = (part + light.AveragedFrames - 1) % Parts;
    context.DrawBound("sky_light/look_up.frag", variant,
      arguments.Set("place", place).Set("skyMaps", light.Maps.Data(turned * lookups, lookups)));
  }
}

vtkGISkyLight::vtkGISkyLight() = default;
vtkGISkyLight::~vtkGISkyLight() = default;

void vtkGISkyLight::ReleaseGraphicsResources(vtkWindow*) {}

const vtkGISkyLight::ViewLight* vtkGISkyLight::Find(vtkRenderer* renderer) const
{
  const ViewState* view = this->Views ? this->Views->FindView(renderer) : nullptr;
  return view ? view->Find<ViewLight>(this) : nullptr;
}

int vtkGISkyLight::GetDrawnMaps(vtkRenderer* renderer)
{
  const ViewLight* light = this->Find(renderer);
  return light ? light->Maps.Drawn() : 0;
}

int vtkGISkyLight::GetRequiredFrames()
{
  return OwnFrames + (this->Maps + this->FirstMaps - 1) / this->FirstMaps;
}

bool vtkGISkyLight::IsFinished(vtkRenderer* renderer)
{
  const ViewLight* light = this->Find(renderer);
  return !light || !light->Sky.Shines() || light->AveragedFrames >= OwnFrames;
}

void vtkGISkyLight::Plan(LightingPlan& plan, FrameBuilder& frame)
{
  if (HasEnvironment(frame.GetRenderer()) && frame.GetView().Diagonal > 0.0)
  {
    plan.AnnounceSkyLight();
  }
}

void vtkGISkyLight::Contribute(FrameBuilder& frame)
{
  if (!frame.Plan().LightsSky())
  {
    return;
  }
  ViewLight& light = frame.ViewState<ViewLight>(this);
  light.SkyChanged = light.Sky.Update(frame.GetRenderer());
  if (!light.Sky.Shines())
  {
    return;
  }
  frame.Capture().Request(resource::Facet);
  this->AddMaps(frame, light);
  this->AddLookups(frame, light);
}

void vtkGISkyLight::AddMaps(FrameBuilder& frame, ViewLight& light)
{
  const double affordable = 1e6 * this->CellBudget / std::max(CellsOfCasters(frame.Capture()), 1.0);
  light.MapCount =
    WholeParts(std::min<double>(this->Maps, std::max<double>(FewestMaps, std::floor(affordable))));
  const double share = std::min(1.0, static_cast<double>(light.MapCount) / this->Maps);
  SkyMaps::Settings settings;
  settings.Maps = light.MapCount;
  settings.MapSize = this->MapSize;
  settings.FirstMaps = ShareOf(this->FirstMaps, share);
  settings.MapsPerFrame = ShareOf(this->MapsPerFrame, share);
  settings.NewMaps = ShareOf(this->FirstMaps, affordable / (RenewingFrames * this->FirstMaps));
  const int width = SkyMaps::AtlasWidth(settings);
  History& atlas = frame.Keep(Atlas, { GL_DEPTH_COMPONENT16, width, width, 0 });
  light.Atlas = &atlas;
  frame.AddPass("sky-light-maps")
    .UpdateHistory(atlas)
    // Reading the depth orders this pass after the capture, which updates the casters.
    .Read(resource::Depth)
    .Execute([&light, &atlas, settings, &scene = frame.Capture()](FrameContext& context) {
      light.Maps.Draw(context, scene, atlas, light.Sky, light.SkyChanged, settings);
    });
}

void vtkGISkyLight::AddLookups(FrameBuilder& frame, ViewLight& light)
{
  const View& view = frame.GetView();
  const bool still = view.StillFrames > 0;
  const Grid grid(view, still ? 1 : 1 << this->Resolution);
  const int lookups = light.MapCount / Parts;
  const bool odd = view.FrameNumber % 2 != 0;
  History* mean = nullptr;
  auto& pass = frame.AddPass("sky-light");
  // Frames with a part of the maps are not worth keeping.
  const bool continued =
    still && light.Maps.IsComplete() && light.LastAveraged + 1 == view.FrameNumber;
  light.AveragedFrames = continued ? light.AveragedFrames + 1 : 1;
  if (grid.Stride == 1)
  {
    // The mean of still frames, which two textures hold in turn.
    mean = &frame.Keep(std::string(Raw) + (odd ? ".odd" : ".even"), grid.Texels(GL_RGBA32UI));
    History& previous =
      frame.Keep(std::string(Raw) + (odd ? ".even" : ".odd"), grid.Texels(GL_RGBA32UI));
    light.AveragedFrames = previous.Written ? light.AveragedFrames : 1;
    light.LastAveraged = light.Maps.IsComplete() ? view.FrameNumber : light.LastAveraged;
    pass.ReadHistory(previous, "previousTexture").WriteHistory(*mean);
  }
  else
  {
    pass.Write(Raw, grid.Texels(GL_RGBA32UI));
  }
  const Texture* target = mean ? &mean->Storage : nullptr;
  pass.Read(resource::DepthCopy)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::Facet)
    .ReadHistory(*light.Atlas, "fieldAtlas")
    .Execute([this, &light, grid, lookups, target](FrameContext& context) {
      this->LookUp(context, light, grid, lookups, target ? *target : *context.Output(Raw));
    });
  if (grid.Stride > 1)
  {
    frame.AddPass("sky-light-filter")
      .Read(Raw, "rawTexture")
      .Write(Filtered, { GL_RGBA32UI, grid.Size.x, grid.Size.y, 0 })
      .Execute([grid](FrameContext& context) { grid.Filter(context); });
  }
  IndirectLight sky;
  sky.Kind = IndirectKind::Sky;
  sky.Declare = [&, mean](PassDeclaration& draw) {
    draw.Read(resource::DepthCopy).Read(resource::Albedo).Read(resource::Normal);
    mean ? draw.ReadHistory(*mean, "rawTexture") : draw.Read(Filtered, "rawTexture");
    draw.Offer(this->GetShaderParameters());
  };
  const double reflected = frame.Plan().KnowsReflectedLight() ? 0.0 : this->Interreflection;
  sky.Draw = [&light, grid, reflected](FrameContext& context) {
    Arguments arguments = grid.Arguments();
    arguments.Sample("openLight", &light.Sky.OpenLight())
      .Set("openTexels", SkyDirections::OpenTexels)
      .Set("reflectedShare", reflected)
      .Set("viewToSky", light.Sky.ToSky() * glm::mat3(glm::dmat3(context.GetView().ViewToWorld)));
    context.DrawBound("sky_light/irradiance.frag", grid.Variant(), arguments);
  };
  sky.Forward = this->MakeForwardPart(frame, light);
  frame.AddIndirectLight(std::move(sky));
}

ForwardPart vtkGISkyLight::MakeForwardPart(FrameBuilder& frame, const ViewLight& light)
{
  ForwardPart part;
  part.Source = "sky_light/forward.glsl";
  // Live probes add what was reflected.
  const bool alone = !frame.Plan().HasKind(IndirectKind::LiveProbes);
  part.OnSurfaces = { { "GI_SKY_SHARE", alone ? "1.0" : "0.0" },
    { "GI_SKY_LOOKUPS", std::to_string(SurfaceLookups) } };
  part.InVolumes = part.OnSurfaces;
  part.InVolumes["GI_SKY_LOOKUPS"] = std::to_string(VolumeLookups);
  part.Textures = 2;
  part.Bind = [this, &light, toWorld = frame.GetView().ViewToWorld](ForwardProgram& program) {
    const SkyMaps& maps = light.Maps;
    const int lookups = program.IsOfVolume() ? VolumeLookups : SurfaceLookups;
    program.SetField(toWorld, maps.Center(), this->Intensity);
    program.Set(Arguments()
                  .Set("fieldMaps", maps.Data(0, lookups))
                  .Set("fieldHalf", 0.5 * this->MapSize)
                  .Set("fieldGrainSize", maps.Texel() * GrainTexels)
                  .Set("fieldToSky", light.Sky.ToSky())
                  .Set("fieldOpenTexels", SkyDirections::OpenTexels));
    program.SetTexture("fieldAtlas", light.Atlas->Storage.Get());
    program.SetTexture("fieldOpen", light.Sky.OpenLight().Get());
  };
  return part;
}
