// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What lights a frame, decided before any technique adds a pass: no answer depends on the order of techniques.
 */
#pragma once

#include "light/IndirectLight.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace penumbra
{
class LightingPlan
{
public:
  /// Take a share of the lights' strength, 0 to 1, and spread it evenly over all directions. Indirect light that is
  /// known replaces it.
  void SpreadLight(double share) { this->Share = share; }
  double SpreadShare() const { return this->Known.empty() ? this->Share : 0.0; }

  /// Surfaces that hide one another from ambient light reflect it, too, by this share of their colour, 0 to 1.
  void SetInterreflection(double share) { this->InterreflectionShare = share; }
  double Interreflection() const { return this->InterreflectionShare; }

  /// A technique will add indirect light (FrameBuilder::AddIndirectLight).
  /// detail: what is nearer than this hides light without the technique's knowledge, world units.
  void KnowIndirectLight(IndirectKind kind, double detail) { this->Known.push_back({ kind, detail }); }
  bool KnowsIndirectLight() const { return !this->Known.empty(); }
  /// Whether light is known around surfaces, not only at their points.
  bool KnowsLightAround() const
  {
    return std::any_of(this->Known.begin(), this->Known.end(),
      [](const Source& source) { return source.Kind != IndirectKind::BakedOnSurfaces; });
  }
  /// The coarsest detail of what is known; infinity where nothing is.
  double IndirectDetail() const
  {
    double detail = this->Known.empty() ? std::numeric_limits<double>::infinity() : 0.0;
    for (const Source& source : this->Known)
    {
      detail = std::max(detail, source.Detail);
    }
    return detail;
  }

  /// Baked light no longer fits: a technique whose light follows the scene should stand in.
  void RequestLiveLight() { this->LiveLightWanted = true; }
  bool NeedsLiveLight() const
  {
    return this->LiveLightWanted && this->Known.empty() && !this->ByRays;
  }

  /// Rays draw all that they see, translucent props too, and average still frames themselves.
  void DrawByRays() { this->ByRays = true; }
  bool IsDrawnByRays() const { return this->ByRays; }

private:
  struct Source
  {
    IndirectKind Kind;
    double Detail;
  };
  std::vector<Source> Known;
  double Share = 0.0;
  double InterreflectionShare = 0.0;
  bool LiveLightWanted = false;
  bool ByRays = false;
};
}
