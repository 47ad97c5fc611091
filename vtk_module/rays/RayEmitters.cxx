// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayEmitters.h"

#include "base/Luminance.h"
#include "rays/EmitterTree.h"
#include "rays/RayGeometry.h"

#include <algorithm>

namespace penumbra
{
namespace
{
// Maximum number of emitting triangles in the tree. Light from others is found only by random rays.
constexpr std::size_t MaxEmitters = 4000000;

/// Approximate emission of a part. It determines only how often the part is sampled.
double Strength(const shared::RaySurface& surface, const glm::vec3& picture)
{
  const int flags = surface.Where.z;
  const bool colored = (flags & (GI_SURFACE_POINT_COLORS | GI_SURFACE_CELL_COLORS)) != 0 ||
    glm::floatBitsToInt(surface.More.x) >= 0;
  const bool phong = (flags & GI_SURFACE_MODEL) == GI_SURFACE_PHONG;
  const bool notSampled = (flags & (GI_SURFACE_PARTLY | GI_SURFACE_PLACE_COLORS)) != 0 ||
    (flags & GI_SURFACE_MODEL) == GI_SURFACE_UNLIT;
  return notSampled
    ? 0.0
    : (colored && phong ? 0.5 * surface.Factors.y
                        : Luminance(surface.Emission.r * picture.r, surface.Emission.g * picture.g,
                            surface.Emission.b * picture.b));
}
}

bool RayEmitters::EmittingPart::HasTrianglesOf(const EmittingPart& other) const
{
  return this->Part == other.Part && this->Surface == other.Surface &&
    this->Strength == other.Strength && this->MeshKey == other.MeshKey &&
    this->CellTime == other.CellTime && this->PointTime == other.PointTime &&
    this->ToWorld == other.ToWorld && this->Places == other.Places;
}

void RayEmitters::Update(const std::vector<RayPart>& parts,
  std::vector<shared::RaySurface>& surfaces, const std::vector<std::int32_t>& indices,
  const std::vector<glm::vec3>& meanColors, const glm::dvec3& origin)
{
  std::vector<EmittingPart> emitting;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const RayPart& part = parts[i];
    shared::RaySurface& surface = surfaces[indices[i]];
    const double strength = Strength(surface, meanColors[i]);
    surface.Emission.w = 0.0f;
    // Points on the back of a surface with another material there are not sampled.
    if (strength > 0.0 && !part.HasBack)
    {
      emitting.push_back({ i, indices[i], strength, part.MeshKey, part.CellTime, part.PointTime,
        part.ToWorld, part.Places });
    }
  }
  const bool same = this->Built && this->Origin == origin &&
    std::equal(emitting.begin(), emitting.end(), this->Parts.begin(), this->Parts.end(),
      [](const EmittingPart& a, const EmittingPart& b) { return a.HasTrianglesOf(b); });
  if (!same)
  {
    this->Built = false;
    this->Origin = origin;
    this->Parts = std::move(emitting);
    this->Build(parts, origin);
    this->Built = true;
  }
  for (const EmittingPart& part : this->Parts)
  {
    surfaces[part.Surface].Emission.w = part.Density;
    surfaces[part.Surface].Clip.z = glm::floatBitsToInt(part.Fineness);
  }
}

void RayEmitters::Build(const std::vector<RayPart>& parts, const glm::dvec3& origin)
{
  std::vector<EmittingTriangle> triangles;
  double total = 0.0;
  double squares = 0.0;
  for (EmittingPart& part : this->Parts)
  {
    const RayPart& source = parts[part.Part];
    const RayGeometry geometry = source.MakeGeometry();
    const std::vector<RayPlace> single(1);
    const std::vector<RayPlace>& places = source.Places ? *source.Places : single;
    // Only triangles can be sampled.
    if (geometry.Triangles.size() != geometry.Size() ||
      triangles.size() + places.size() * geometry.Triangles.size() > MaxEmitters)
    {
      continue;
    }
    double partArea = 0.0;
    const std::size_t before = triangles.size();
    for (const RayPlace& place : places)
    {
      glm::dmat4 toScene = source.ToWorld;
      if (source.Places)
      {
        glm::dmat4 placed{ glm::dmat3(place.Turn) };
        placed[3] = glm::dvec4(place.At, 1.0);
        toScene = toScene * placed;
      }
      toScene[3] = toScene * glm::dvec4(geometry.Origin, 1.0) - glm::dvec4(origin, 0.0);
      for (std::size_t t = 0; t < geometry.Triangles.size(); ++t)
      {
        EmittingTriangle triangle{ {}, 0.0, part.Surface, static_cast<int>(t) };
        for (int c = 0; c < 3; ++c)
        {
          triangle.Corners[c] =
            glm::dvec3(toScene * glm::dvec4(geometry.Points[geometry.Triangles[t][c]], 1.0));
        }
        const double area = 0.5 *
          glm::length(glm::cross(
            triangle.Corners[1] - triangle.Corners[0], triangle.Corners[2] - triangle.Corners[0]));
        if (area > 0.0 && std::isfinite(area))
        {
          triangle.Power = part.Strength * area;
          total += triangle.Power;
          squares += part.Strength * triangle.Power;
          partArea += area;
          triangles.push_back(triangle);
        }
      }
    }
    part.Fineness =
      partArea > 0.0 ? static_cast<float>((triangles.size() - before) / partArea) : 0.0f;
  }
  for (EmittingPart& part : this->Parts)
  {
    part.Density = part.Fineness > 0.0f ? static_cast<float>(part.Strength / total) : 0.0f;
  }
  this->Triangles = triangles.size();
  this->WholeArea = squares > 0.0 ? total * total / squares : 0.0;
  EmitterTree tree = MakeEmitterTree(std::move(triangles));
  if (tree.Records.empty())
  {
    tree.Records.emplace_back();
  }
  this->Levels = tree.Levels;
  this->Cube = tree.Cube;
  this->Records.Release();
  this->Records.Write(
    this->Records.Allocate(tree.Records.size()), tree.Records.data(), tree.Records.size());
}

void RayEmitters::AddTo(Arguments& arguments) const
{
  this->Records.AddSampler(arguments, "rayEmitters");
  arguments.Set("emitterCount", static_cast<int>(this->Triangles))
    .Set("emitterLevels", this->Levels)
    .Set("emitterCube", this->Cube);
}

void RayEmitters::ReleaseGraphicsResources()
{
  this->Records.Release();
  this->Built = false;
}
}
