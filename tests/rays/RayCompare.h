// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Two tracers' answers to the same rays, and an explanation of each difference by arithmetic in
// double precision.
#pragma once

#include "RayStage.h"

namespace penumbra_test
{
struct Comparison
{
  std::size_t Rays = 0;
  std::size_t Hits = 0;   ///< by the reference
  std::size_t Same = 0;   ///< same primitive and distance, or both miss
  std::size_t Shared = 0; ///< the two primitives have a vertex in common and the ray passes there
  std::size_t Coincident = 0; ///< other primitives at the same distance
  std::size_t Edge = 0;       ///< one tracer's triangle is touched on its outline only
  /// A triangle seen edge-on, or a needle: floats do not tell its distance to 1e-4.
  std::size_t Grazing = 0;
  std::size_t Right = 0;      ///< of Edge: doubles decide for the tracer under test
  /// The same primitive, and doubles confirm the tested tracer's distance, not the reference's.
  std::size_t Reference = 0;
  std::size_t Unexplained = 0;
  std::string First; ///< the first unexplained one

  std::string Line(const std::string& name) const;
};

/// Whether the distance of an answer's hit is not known to that share of it, in floats.
bool IsDistanceUncertain(const RayWorld& world, const penumbra::shared::RayQuery& ray,
  const penumbra::shared::RayAnswer& answer, double tolerance);

Comparison Compare(const RayWorld& world, const Rays& rays, const Answers& reference,
  const Answers& answers, double tolerance = 1e-4);
}
