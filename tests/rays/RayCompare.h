// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Comparison of two tracers on the same rays. Arithmetic in double precision explains each difference.
#pragma once

#include "RayStage.h"

namespace penumbra_test
{
struct Comparison
{
  std::size_t Rays = 0;
  std::size_t Hits = 0;       ///< hits of the reference
  std::size_t Same = 0;       ///< the same primitive and distance, or both miss
  std::size_t Shared = 0;     ///< the primitives share a vertex near which the ray passes
  std::size_t Coincident = 0; ///< different primitives at the same distance
  std::size_t Edge = 0;       ///< a tracer's ray passes through the outline of its triangle
  std::size_t Right = 0;      ///< of Edge: doubles confirm the tested tracer
  std::size_t Grazing =
    0; ///< triangles seen edge-on, and needles: floats do not resolve the distance
  std::size_t Reference =
    0; ///< the same primitive: doubles confirm the tested tracer's distance, not the reference's
  std::size_t Unexplained = 0; ///< anything else
  std::string First;           ///< description of the first unexplained difference

  std::string Line(const std::string& name) const;
};

/// Whether floats do not resolve the distance of a hit to a relative tolerance.
bool IsDistanceUncertain(const RayWorld& world, const penumbra::shared::RayQuery& ray,
  const penumbra::shared::RayAnswer& answer, double tolerance);

Comparison Compare(const RayWorld& world, const Rays& rays, const Answers& reference,
  const Answers& answers, double tolerance = 1e-4);
}
