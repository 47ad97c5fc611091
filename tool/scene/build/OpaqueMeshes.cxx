// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/OpaqueMeshes.h"

#include "rays/parts/GatherCache.h"

namespace penumbra::tool
{
void ForEachOpaqueMesh(vtkRenderer* renderer, bool unlit, Reporter& reporter,
  const std::function<std::size_t(const MeshInstance&)>& visit)
{
  std::size_t translucent = 0, balls = 0, degenerate = 0;
  GatherCache cache;
  std::vector<vtkProp*> unsupported;
  for (const RayPart& part : GatherRayParts(renderer, unsupported, cache))
  {
    if (!unlit && (part.Surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_UNLIT)
    {
      continue;
    }
    if (part.Surface.Color.a < 1.0f)
    {
      ++translucent;
      continue;
    }
    const RayGeometry geometry = part.MakeGeometry();
    const RayAttributes attributes = part.MakeAttributes();
    balls += geometry.Spheres.size() + geometry.Cylinders.size();
    const auto add = [&](const RayPlace* place, const glm::dmat4& toWorld) {
      const bool mirrored = glm::determinant(glm::dmat3(toWorld)) < 0.0;
      degenerate += visit({ part, geometry, attributes, place, toWorld, mirrored });
    };
    if (!part.Places)
    {
      add(nullptr, part.ToWorld);
      continue;
    }
    for (const RayPlace& place : *part.Places)
    {
      glm::dmat4 transform{ glm::dmat3(place.Turn) };
      transform[3] = glm::dvec4(place.At, 1.0);
      add(&place, part.ToWorld * transform);
    }
  }
  const auto note = [&reporter](std::size_t count, const char* text) {
    if (count > 0)
    {
      reporter.Note(fmt::format("{} {}", count, text));
    }
  };
  note(translucent, "translucent surfaces are left out: only opaque ones are baked");
  note(balls, "balls and sticks are left out: they have no triangles");
  note(unsupported.size(), "objects are left out: ray tracing does not support them");
  note(degenerate, "triangles without area or with points that are not finite are left out");
}
}
