// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Irradiance at the corners of patches, to be interpolated between them.
#pragma once

#include "bake/radiosity/DirectLight.h"

#include <cstdint>

namespace penumbra::radiosity
{
/// Patches that meet at less than 30 degrees, of one surface, share the points between them.
struct SmoothPoints
{
  std::vector<Point> Points;
  std::vector<std::array<std::uint32_t, 3>> OfElement; ///< in the order of the element's corners
  std::vector<Color> Irradiance;                       ///< of each point
};

SmoothPoints MakeSmoothPoints(const PatchMesh& mesh, const std::vector<Element>& elements);

/// Direct light around every point: the mean by area over the elements there, each met a little off the
/// corner, clear of what stands at its edge. shadowRays: about so many from each point to a source.
std::vector<Color> DirectAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const PatchRays& rays, const LightSources& sources, int shadowRays,
  const tool::Progress& advance = {});

/// The mean of a value of the elements around every point, by their area.
std::vector<Color> MeanAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const std::vector<Color>& values);
}
