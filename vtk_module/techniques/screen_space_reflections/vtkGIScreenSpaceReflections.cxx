// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIScreenSpaceReflections.h"

#include "capture/MaterialTable.h"
#include "capture/SceneCapture.h"
#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"

#include "reflection.h"

#include <array>

vtkStandardNewMacro(vtkGIScreenSpaceReflections);

using namespace penumbra;

namespace
{
constexpr const char* Pyramid = "screen-space-reflections.pyramid";
constexpr const char* Rays = "screen-space-reflections.rays";
constexpr const char* FoundLight = "screen-space-reflections.found";
constexpr const char* Ends = "screen-space-reflections.ends";
constexpr const char* LobeTable = "screen-space-reflections.lobes";

// Order among the passes that modify the picture: before those that average it.
constexpr int CompositeOrder = 300;

// Automatic thickness, as a fraction of the scene's diagonal.
constexpr double AutomaticThickness = 0.001;

constexpr int TableSize = 32;
constexpr int Neighbours = 12; // number of neighbouring pixels whose rays a pixel shares

enum FallbackValues
{
  None,
  Environment,
  RayTraced
};

int CeilDivide(int size, int divisor)
{
  return (size + divisor - 1) / divisor;
}

/// Positions of the levels of the depth pyramid in its texture: the first is at the origin, the others form
/// a column beside it. The last entry is the size of the texture.
std::array<glm::ivec2, GI_PYRAMID_LEVELS + 2> PyramidLayout(const glm::ivec4& viewport)
{
  std::array<glm::ivec2, GI_PYRAMID_LEVELS + 2> layout{};
  int height = 0;
  for (int level = 1; level <= GI_PYRAMID_LEVELS; ++level)
  {
    layout[level] = { viewport.z, height };
    height += CeilDivide(viewport.w, 1 << level);
  }
  layout.back() = { viewport.z + CeilDivide(viewport.z, 2), std::max(viewport.w, height) };
  return layout;
}

std::vector<glm::ivec2> LevelOffsets(const glm::ivec4& viewport)
{
  const auto layout = PyramidLayout(viewport);
  return { layout.begin(), layout.end() - 1 };
}

/// Declares what the passes of a frame have in common.
struct Reflections
{
  FrameBuilder& Frame;
  History& Table; ///< reflectance of the lobes, see lobe_table.comp
  Defines Variant;

  /// A pass that evaluates the reflection lobes of the surfaces in the G-buffer.
  PassDeclaration& AddPass(const std::string& name) const
  {
    return this->Frame.AddPass(name)
      .Read(resource::DepthCopy)
      .Read(resource::Albedo)
      .Read(resource::Normal)
      .ReadIfPresent(resource::Surface)
      .ReadHistory(this->Table, "lobeTable")
      .Offer(this->Frame.Capture().Materials().ShaderArguments())
      .Offer(this->Frame.Plan().Rules().ShaderArguments());
  }

  glm::vec3 AmbientLight() const
  {
    return glm::vec3(this->Frame.Plan().SpreadShare() * this->Frame.Lights().TotalColor());
  }

  /// Let the tracing pass trace rays through the scene where the screen shows nothing.
  void FallBackToRays(PassDeclaration& pass, Defines& variant, RayProps& rays) const
  {
    variant.merge(rays.ShaderDefines());
    variant["GI_FALLBACK_RAYS"] = "1";
    pass.Offer(rays.ShaderArguments())
      .Offer(this->Frame.Lights().InWorld(rays.Origin()))
      .Offer(this->Frame.GetView().ToScene(rays.Origin()))
      .Offer(Arguments()
               .Set("lampShare", 1.0 - this->Frame.Plan().SpreadShare())
               .Set("ambientLight", this->AmbientLight()));
  }

  /// Blend the reflections into a picture. ends: how rays ended, for the debug view, or nullptr.
  void Composite(PassDeclaration& pass, const char* picture, bool keep, History* ends) const
  {
    Defines variant = this->Variant;
    if (picture != resource::Color)
    {
      variant[picture == resource::Radiance ? "GI_RADIANCE" : "GI_LIT_PARTS"] = "1";
    }
    if (ends)
    {
      variant["GI_DEBUG"] = "1";
      pass.ReadHistory(*ends, "endTexture");
    }
    pass.Read(resource::LitRadiance)
      .Read(resource::Reflection)
      .ReadIfPresent(resource::Surroundings, "GI_SURROUNDINGS")
      .ReadIfPresent(resource::Irradiance, "GI_IRRADIANCE")
      .ReadIfPresent(resource::AmbientVisibility, "GI_AMBIENT_VISIBILITY")
      .Draw("screen_space_reflections/composite.frag", variant,
        Arguments().Set("keep", keep ? 1.0 : 0.0).Set("ambientLight", this->AmbientLight()));
  }
};
}

vtkGIScreenSpaceReflections::vtkGIScreenSpaceReflections() = default;
vtkGIScreenSpaceReflections::~vtkGIScreenSpaceReflections() = default;

const char* vtkGIScreenSpaceReflections::GetOfferedResource()
{
  return resource::Reflection;
}

bool vtkGIScreenSpaceReflections::Reflects(FrameBuilder& frame) const
{
  return frame.GetView().Diagonal > 0.0 && frame.Capture().Reflects(this->MinimumReflectance);
}

void vtkGIScreenSpaceReflections::Plan(LightingPlan& plan, FrameBuilder& frame)
{
  if (this->Reflects(frame))
  {
    plan.KeepLitParts();
  }
}

void vtkGIScreenSpaceReflections::Contribute(FrameBuilder& frame)
{
  if (!this->Reflects(frame))
  {
    return;
  }
  const View& view = frame.GetView();
  frame.RequestLitRadiance();
  const double thickness =
    this->Thickness > 0.0 ? this->Thickness : AutomaticThickness * view.Diagonal;
  Reflections reflections = { frame, frame.Keep(LobeTable, { GL_RGBA16F, TableSize, TableSize, 0 }),
    {} };
  if (frame.Capture().IsExtended())
  {
    reflections.Variant["GI_EXTENDED"] = "1";
  }
  if (frame.Plan().Rules().ChangesData())
  {
    reflections.Variant["GI_DATA_COLORS"] = "1";
  }
  if (!reflections.Table.Written)
  {
    reflections.Table.Storage.SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    reflections.Table.Storage.SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    frame.AddPass("reflection-lobes")
      .WriteHistory(reflections.Table, "table")
      .Compute(
        "screen_space_reflections/lobe_table.comp", {}, {}, Work::Items(TableSize, TableSize));
  }
  const glm::ivec2 size = PyramidLayout(view.Viewport).back();
  const std::vector<glm::ivec2> levels = LevelOffsets(view.Viewport);
  frame.AddPass("reflection-pyramid")
    .Read(resource::DepthCopy)
    .Read(resource::Normal)
    .Write(Pyramid, { GL_RG32F, size.x, size.y, 0 }, "pyramid")
    .Compute("screen_space_reflections/depth_pyramid.comp", {},
      Arguments().Set("levelOffset", levels).Set("thickness", thickness),
      // One invocation reduces 4 x 4 pixels.
      Work::Items(CeilDivide(view.Viewport.z, 4), CeilDivide(view.Viewport.w, 4)));
  auto& trace = reflections.AddPass("reflection-trace")
                  .Read(Pyramid, "pyramidTexture")
                  .Read(resource::LitRadiance)
                  .Write(Rays, frame.WindowTexture(GL_RGBA32F, this->Samples), "rays")
                  .Write(FoundLight, frame.WindowTexture(GL_RGBA16F, this->Samples), "light");
  Defines variant = reflections.Variant;
  if (this->Fallback == RayTraced)
  {
    RayProps& rays = frame.Rays("reflections show them on the screen only");
    reflections.FallBackToRays(trace, variant, rays);
  }
  // Kept as a history, so that vtkGIPass::GetBuffer can return it.
  History* ends = this->DebugView ? &frame.Keep(Ends, frame.WindowTexture(GL_RGBA32F)) : nullptr;
  if (ends)
  {
    variant["GI_DEBUG"] = "1";
    trace.WriteHistory(*ends, "ends");
  }
  trace.Compute("screen_space_reflections/trace.comp", variant,
    Arguments().Set("levelOffset", levels).Set("reach", view.Diagonal).Set("thickness", thickness),
    Work::Items(view.Viewport.z, view.Viewport.w));
  reflections.AddPass("reflection-reuse")
    .Read(Rays, "rayTexture")
    .Read(FoundLight, "foundTexture")
    .Write(resource::Reflection, frame.WindowTexture(GL_RGBA16F))
    .Write(resource::ReflectionReach, frame.WindowTexture(GL_R16F))
    .Draw("screen_space_reflections/reuse.frag", reflections.Variant,
      Arguments().Set("neighbours", this->Filter ? Neighbours : 0));
  const bool keep = this->Fallback != None;
  reflections.Composite(
    reflections.AddPass("reflection-composite").Modify(resource::Color, CompositeOrder, "before"),
    resource::Color, keep, ends);
  reflections.Composite(reflections.AddPass("reflection-composite-radiance")
                          .ModifyIfPresent(resource::Radiance, CompositeOrder, "before"),
    resource::Radiance, keep, ends);
  for (const char* part : { resource::LitShown, resource::LitEncoded })
  {
    reflections.Composite(reflections.AddPass(std::string("reflection-composite-") + part)
                            .ModifyIfPresent(part, CompositeOrder, "before"),
      part, keep, nullptr);
  }
}
