// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Irradiance at the corners of patches, to be interpolated between them.
#ifndef penumbra_tool_SmoothPoints_h
#define penumbra_tool_SmoothPoints_h

#include "DirectLight.h"

namespace penumbra::radiosity
{
/// Patches that meet at less than 30 degrees, of one surface, share the points between them.
struct SmoothPoints
{
  struct Corner
  {
    Point At{ 0.0 }; ///< the vertex
    Point Inside{
      0.0
    }; ///< a little towards the patches' middle, clear of what stands at their edge
    Point Normal{ 0.0 };
  };
  std::vector<Corner> Points;
  std::vector<std::array<std::uint32_t, 3>> OfElement; ///< in the order of the element's corners
  std::vector<Color> Irradiance;                       ///< of each point
};

SmoothPoints MakeSmoothPoints(const PatchMesh& mesh, const std::vector<Element>& elements);

/// The mean of a value of the elements around every point, by their area.
std::vector<Color> MeanAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const std::vector<Color>& values);
}

#endif
