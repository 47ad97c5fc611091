// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/ddgi/LiveProbes.h"

#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <limits>

namespace penumbra
{
namespace
{
constexpr int LightTexels = GI_FIELD_LIGHT;
constexpr int DistanceTexels = GI_FIELD_DISTANCE;

// Directions along a spiral, so that neighbours in the table are neighbours on the sphere (Bauer 2000, Distribution
// of Points on a Sphere with Application to Star Catalogs).
std::vector<glm::dvec3> EvenDirections(int count)
{
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = std::sqrt(glm::pi<double>() * count) * std::acos(z);
    const double radius = std::sqrt(1.0 - z * z);
    directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return directions;
}

// The rows of the table of directions, see glsl/ddgi/directions.glsl.
std::vector<glm::vec4> DirectionTable(int rays, int parts)
{
  std::vector<glm::vec4> table;
  for (const glm::dvec3& direction : EvenDirections(rays))
  {
    table.emplace_back(direction, 0.0);
  }
  const std::vector<glm::dvec3> ofPart = EvenDirections(rays / parts);
  for (int i = 0; i < rays; ++i)
  {
    // Any rotations will do, as long as they differ.
    const double angle = glm::two_pi<double>() * (i % parts) / parts;
    const glm::dmat4 once = glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(1.0, 0.0, 0.0));
    const glm::dmat4 twice = glm::rotate(once, angle, glm::dvec3(0.0, 1.0, 0.0));
    table.emplace_back(glm::dmat3(twice) * ofPart[i / parts], 0.0);
  }
  return table;
}

void Fill(const Texture& texture, const std::vector<glm::vec4>& texels)
{
  glBindTexture(GL_TEXTURE_2D, texture.Get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.Desc().Width, texture.Desc().Height, GL_RGBA,
    GL_FLOAT, texels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

// Number of a probe's rays to emitters, where there are any.
int EmitterRaysOf(int rays)
{
  return std::max(1, rays / 8);
}

void FillAll(const Texture& texture, const glm::vec4& value)
{
  const std::size_t count = static_cast<std::size_t>(texture.Desc().Width) * texture.Desc().Height;
  Fill(texture, std::vector<glm::vec4>(count, value));
}
}

int LiveProbeUpdate::MaximumParts(int rays)
{
  constexpr int most = 8;
  constexpr int leastRays = 8;
  int parts = 1;
  while (2 * parts <= std::min(most, rays / leastRays) && rays % (2 * parts) == 0 &&
    EmitterRaysOf(rays) % (2 * parts) == 0)
  {
    parts *= 2;
  }
  return parts;
}

int LiveProbeUpdate::EmitterRays() const
{
  return this->Rays->HasEmitters() ? EmitterRaysOf(this->RayCount) : 0;
}

LiveProbeMaps LiveProbeMaps::Keep(Frame& frame, int probes, int rays)
{
  const int columns = ProbeUniforms::Columns(probes);
  const int rows = ProbeUniforms::Rows(probes, columns);
  const auto keep = [&](const char* name, GLenum format, int side, int rowCount) {
    return &frame.Keep(name, { format, columns * side, rowCount * side, 0 });
  };
  LiveProbeMaps maps;
  maps.RayResults =
    &frame.Keep("ddgi.rays", { GL_RGBA32F, 2 * rays + EmitterRaysOf(rays), probes, 0 });
  maps.Directions = &frame.Keep("ddgi.directions", { GL_RGBA32F, rays, 2, 0 });
  maps.Light =
    keep("ddgi.light", GL_RGBA32F, LightTexels + 2, ProbeUniforms::Rows(2 * probes, columns));
  // A second map per probe, for the grid point that a relocated probe left.
  maps.Distance =
    keep("ddgi.distance", GL_RG32F, DistanceTexels + 2, ProbeUniforms::Rows(2 * probes, columns));
  maps.Probes = keep("ddgi.probes", GL_RGBA32F, 1, rows);
  maps.NextOffsets = keep("ddgi.places", GL_RGBA32F, 1, rows);
  maps.States = keep("ddgi.states", GL_RGBA32F, 1, rows);
  if (!maps.Directions->Written)
  {
    frame.AddPass("ddgi-directions")
      .WriteHistory(*maps.Directions)
      .Execute([map = &maps.Directions->Storage, rays](FrameContext&) {
        Fill(*map, DirectionTable(rays, LiveProbeUpdate::MaximumParts(rays)));
      });
  }
  return maps;
}

bool LiveProbeMaps::AreEmpty() const
{
  const auto histories = { this->Light, this->Distance, this->Probes, this->NextOffsets,
    this->States };
  return std::any_of(
    histories.begin(), histories.end(), [](const History* history) { return !history->Written; });
}

void LiveProbeMaps::Clear(Frame& frame) const
{
  frame.AddPass("ddgi-clear")
    .WriteHistory(*this->Light)
    .WriteHistory(*this->Distance)
    .WriteHistory(*this->Probes)
    .WriteHistory(*this->NextOffsets)
    .WriteHistory(*this->States)
    .Execute([maps = *this](FrameContext&) {
      for (History* history : { maps.Light, maps.Distance })
      {
        history->Storage.SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        history->Storage.SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        FillAll(history->Storage, glm::vec4(0.0f));
      }
      FillAll(maps.Probes->Storage, glm::vec4(0.0f));
      FillAll(maps.NextOffsets->Storage, glm::vec4(0.0f));
      FillAll(maps.States->Storage, glm::vec4(0.0f, 0.0f, 1.0f, 0.0f));
    });
}

void LiveProbeMaps::ReadField(PassDeclaration& pass) const
{
  pass.ReadHistory(*this->Light, "fieldLight")
    .ReadHistory(*this->Distance, "fieldDistance")
    .ReadHistory(*this->Probes, "fieldProbes");
}

PassDeclaration& LiveProbeUpdate::AddPass(Frame& frame, const char* name) const
{
  return frame.AddPass(name).Offer(this->Uniforms.ShaderArguments());
}

void LiveProbeUpdate::Scroll(
  Frame& frame, const LiveProbeMaps& maps, int number, const glm::ivec3& moved) const
{
  this->AddPass(frame, "ddgi-scroll")
    .UpdateHistory(*maps.Probes, "probes")
    .UpdateHistory(*maps.Distance, "distances")
    .UpdateHistory(*maps.NextOffsets, "places")
    .UpdateHistory(*maps.States, "states")
    .Compute("ddgi/scroll.comp", this->Uniforms.Variant(),
      Arguments().Set("number", number).Set("moved", moved),
      Work::Items(this->Uniforms.Grids.Begin(number + 1) - this->Uniforms.Grids.Begin(number)));
}

void LiveProbeUpdate::Trace(Frame& frame, const LiveProbeMaps& maps) const
{
  Defines variant = this->Rays->ShaderDefines();
  variant.merge(this->Uniforms.Variant());
  if (this->SkyApart)
  {
    variant["GI_SKY_APART"] = "1";
    variant["GI_SKY_AT_HITS"] = "1";
  }
  if (this->SeeksEmitters)
  {
    variant["GI_SEEK_EMITTERS"] = "1";
  }
  auto& pass = this->AddPass(frame, "ddgi-trace")
                 .ReadHistory(*maps.Directions, "fieldDirections")
                 .UpdateHistory(*maps.RayResults, "found")
                 .UpdateHistory(*maps.States, "states");
  maps.ReadField(pass);
  pass.Offer(this->Rays->ShaderArguments())
    .Offer(this->Rays->SkyCells(this->RayCount))
    .Offer(this->Lights->InWorld(this->Rays->Origin()))
    .Offer(frame.GetView().ToScene(this->Rays->Origin()))
    .Compute("ddgi/trace.comp", variant,
      Arguments()
        .Set("rays", this->RayCount)
        .Set("emitterRays", this->EmitterRays())
        .Set("parts", this->Parts)
        .Set("part", this->Part)
        .Set("keepsEmitted", this->KeepsEmitted)
        .Set("update", this->UpdateNumber)
        .Set("firstProbe", this->First)
        .Set("lastProbe", this->Last)
        .Set("lit", this->UpdateNumber > 0),
      Work::ItemsInRows(std::size_t((this->RayCount + this->EmitterRays()) / this->Parts) *
        std::size_t(this->Last - this->First)));
}

void LiveProbeUpdate::Relocate(Frame& frame, const LiveProbeMaps& maps, bool geometryMoves) const
{
  const int probes = this->Uniforms.Grids.Size();
  auto& pass = this->AddPass(frame, "ddgi-relocate")
                 .ReadHistory(*maps.RayResults, "foundTexture")
                 .ReadHistory(*maps.Directions, "fieldDirections")
                 .UpdateHistory(*maps.NextOffsets, "places")
                 .UpdateHistory(*maps.States, "states");
  maps.ReadField(pass);
  pass.Offer(this->Rays->ShaderArguments())
    .Compute("ddgi/relocate.comp", this->Rays->ShaderDefines(),
      Arguments()
        .Set("probeCount", probes)
        .Set("rays", this->RayCount)
        .Set("parts", this->Parts)
        .Set("update", this->UpdateNumber - 1)
        .Set("geometryMoves", geometryMoves),
      Work::Items(probes));
  this->AddPass(frame, "ddgi-take-over")
    .ReadHistory(*maps.Probes, "fieldProbes")
    .UpdateHistory(*maps.NextOffsets, "places")
    .UpdateHistory(*maps.Distance, "distances")
    .UpdateHistory(*maps.Light, "map")
    .UpdateHistory(*maps.States, "states")
    .Compute("ddgi/take_over.comp", {}, Arguments().Set("probeCount", probes), Work::Items(probes));
}

void LiveProbeUpdate::Connect(Frame& frame, const LiveProbeMaps& maps, int first, int last) const
{
  this->AddPass(frame, "ddgi-connect")
    .ReadHistory(*maps.NextOffsets, "fieldProbes")
    .UpdateHistory(*maps.Probes, "probes")
    .Offer(this->Rays->ShaderArguments())
    .Compute("ddgi/connect.comp", this->Rays->ShaderDefines(),
      Arguments().Set("firstProbe", first).Set("lastProbe", last), Work::Items(last - first));
}

void LiveProbeUpdate::BlendLight(Frame& frame, const LiveProbeMaps& maps, double leastShare) const
{
  const Arguments arguments = Arguments()
                                .Set("emitterRays", this->EmitterRays())
                                .Set("part", this->Part)
                                .Set("least", leastShare)
                                .Set("most", static_cast<double>(std::numeric_limits<int>::max()))
                                .Set("stride", 0);
  if (this->KeepsEmitted)
  {
    this->Blend(frame, maps, "GI_BLEND_EMITTED", arguments, *maps.Light);
  }
  this->Blend(frame, maps, nullptr, arguments, *maps.Light);
}

void LiveProbeUpdate::BlendDistances(
  Frame& frame, const LiveProbeMaps& maps, int mostUpdates, int stride) const
{
  this->Blend(frame, maps, "GI_BLEND_DISTANCE",
    Arguments()
      .Set("least", 0.0)
      .Set("most", static_cast<double>(mostUpdates))
      .Set("stride", stride),
    *maps.Distance);
}

void LiveProbeUpdate::Blend(Frame& frame, const LiveProbeMaps& maps, const char* variant,
  Arguments arguments, History& map) const
{
  this->AddPass(frame, &map == maps.Distance ? "ddgi-blend-distances" : "ddgi-blend")
    .ReadHistory(*maps.RayResults, "foundTexture")
    .ReadHistory(*maps.Directions, "fieldDirections")
    .UpdateHistory(map, "map")
    .UpdateHistory(*maps.States, "states")
    .Compute("ddgi/blend.comp", variant ? Defines{ { variant, "1" } } : Defines{},
      arguments.Set("rays", this->RayCount)
        .Set("parts", this->Parts)
        .Set("update", this->UpdateNumber)
        .Set("firstProbe", this->First),
      Work::Groups(this->Last - this->First));
}
}
