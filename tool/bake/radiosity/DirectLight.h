// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What arrives at elements straight from lights and from what shines.
#pragma once

#include "bake/radiosity/Patches.h"
#include "common/ForEach.h"

#include <cstdint>

namespace penumbra::radiosity
{
/// A light without extent, as vtkLight means it.
struct Lamp
{
  Color Strength{ 0.0 }; ///< irradiance that it gives across its way, at distance 0
  bool Positional = false;
  Point Position{ 0.0 };
  Point Travel{ 0.0, 0.0, -1.0 };     ///< unit, its axis
  Point Attenuation{ 1.0, 0.0, 0.0 }; ///< by powers of the distance
  double ConeCosine = -2.0;           ///< of the half angle; below -1: none
  double Exponent = 1.0;
};

/// Irradiance at a point with a normal, were nothing in the way; toward: where it comes from, far away
/// or the lamp's position.
Color Unblocked(const Lamp& lamp, const Point& at, const Point& normal);

/// The form factor from a point to a polygon, all of which is seen, but for what is below the point's
/// horizon (Lambert 1760; Baum, Rushmeier and Winget 1989, Improving Radiosity Solutions Through the Use
/// of Analytically Determined Form-Factors, equation 6).
double PointFactor(const Point& at, const Point& normal, const std::array<Point, 3>& triangle);

struct LightSources
{
  std::vector<Lamp> Lamps;
  std::vector<Element> Emitters;
};

/// Irradiance at the point: of the lamps, and of emitters by their form factors times the share of
/// shadow rays (so many for each) that reach them.
Color ArrivingAt(const LightSources& sources, const PatchRays& rays, const Point& at,
  const Point& normal, int shadowRays, std::uint64_t stream);

/// The mean irradiance of every element, from so many points of each with one shadow ray to every
/// source.
std::vector<Color> DirectIrradiance(const std::vector<Element>& elements, const PatchRays& rays,
  const LightSources& sources, int points, const tool::Progress& advance = {});
}
