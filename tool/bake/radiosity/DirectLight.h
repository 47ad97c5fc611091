// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Direct irradiance of elements, from lights and emissive surfaces.
#pragma once

#include "bake/radiosity/Patches.h"
#include "common/ForEach.h"

#include "light/LightTable.h"

#include <cstdint>

namespace penumbra::radiosity
{
using Light = penumbra::Light; ///< in world coordinates

/// Irradiance at a point with a normal, without occlusion. A light of colour c gives pi c at distance 0.
Color UnoccludedIrradiance(const Light& light, const Point& at, const Point& normal);

/// The form factor from a point to the part of a triangle above its horizon, without occlusion (Lambert 1760; Baum, Rushmeier
/// and Winget 1989, Improving Radiosity Solutions Through the Use of Analytically Determined Form-Factors, equation 6).
double PointFactor(const Point& at, const Point& normal, const std::array<Point, 3>& triangle);

struct LightSources
{
  std::vector<Light> Lights;
  std::vector<Element> Emitters;
};

/// Irradiance at a point: from lights, and from emitters by their form factors times the share of their shadow rays that are
/// not occluded.
Color IrradianceAt(const LightSources& sources, const PatchRays& rays, const Point& at,
  const Point& normal, int shadowRays, std::uint64_t stream);

/// The mean irradiance of each element, from a number of points with one shadow ray to each source.
std::vector<Color> DirectIrradiance(const std::vector<Element>& elements, const PatchRays& rays,
  const LightSources& sources, int points, const tool::Progress& advance = {});
}
