// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Differences between colours as people see them.
#pragma once

#include <glm/vec3.hpp>

namespace penumbra::tool
{
/// CIE 1976 L*a*b*.
struct Lab
{
  double L = 0;
  double A = 0;
  double B = 0;
};

/// Linear values of an sRGB display (IEC 61966-2-1). Values outside 0..1 are clamped.
glm::dvec3 LinearOfDisplay(const glm::dvec3& display);

/// XYZ of linear sRGB, relative to its white, D65.
glm::dvec3 RelativeXyz(const glm::dvec3& linear);
glm::dvec3 LinearOfRelativeXyz(const glm::dvec3& xyz);

Lab LabOfRelativeXyz(const glm::dvec3& xyz);

/// The colour of an sRGB display. Values outside 0..1 are clamped.
Lab LabOfDisplay(double red, double green, double blue);

struct ColorDifference
{
  double Total = 0; ///< ΔE00; 1 is about the smallest difference that is seen
  double Hue = 0;   ///< |ΔH'|: the part of hue, before it is divided by its weighting function
};

/// CIEDE2000 with all parametric factors 1. Sharma, Wu and Dalal 2005, The CIEDE2000 Color-Difference Formula:
/// Implementation Notes, Supplementary Test Data, and Mathematical Observations.
ColorDifference Ciede2000(const Lab& one, const Lab& other);
}
