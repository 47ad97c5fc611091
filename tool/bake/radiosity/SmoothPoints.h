// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Irradiance at the corners of patches, for interpolation.
#pragma once

#include "bake/radiosity/DirectLight.h"

#include <cstdint>

namespace penumbra::radiosity
{
/// Points shared by patches of the same surface whose normals differ by less than 30 degrees.
struct SmoothPoints
{
  std::vector<Point> Points;
  std::vector<std::array<std::uint32_t, 3>> OfElement; ///< in the order of the element's corners
  std::vector<Color> Irradiance;                       ///< of each point
};

SmoothPoints MakeSmoothPoints(const PatchMesh& mesh, const std::vector<Element>& elements);

/// Direct irradiance of each point: the mean by area over the elements around it, sampled slightly off the corner, to avoid
/// surfaces at its edge. shadowRays: approximate number per point and source.
std::vector<Color> DirectAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const PatchRays& rays, const LightSources& sources, int shadowRays,
  const tool::Progress& advance = {});

/// The mean by area of a value over the elements around each point.
std::vector<Color> MeanAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const std::vector<Color>& values);
}
