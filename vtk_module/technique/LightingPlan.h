// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lighting of a frame. It is decided before any technique adds a pass, so that the order of techniques does not
 * matter.
 */
#pragma once

#include "light/IndirectLight.h"
#include "rays/SurfaceRules.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace penumbra
{
class LightingPlan
{
public:
  /// Take a share of the lights' strength, 0 to 1, and spread it evenly over all directions, unless there is indirect
  /// light.
  void SpreadLight(double share) { this->Share = share; }
  double SpreadShare() const
  {
    return this->Indirect.empty() && !this->LightsSky() ? this->Share : 0.0;
  }

  /// Fraction of their reflectance, 0 to 1, with which occluders of ambient light reflect it.
  void SetInterreflection(double share) { this->InterreflectionShare = share; }
  double Interreflection() const { return this->InterreflectionShare; }

  /// Announce indirect light that a technique will add (FrameBuilder::AddIndirectLight).
  /// detail: distance in world units below which the light does not resolve occluders.
  void AnnounceIndirectLight(IndirectKind kind, double detail)
  {
    this->Indirect.push_back({ kind, detail });
  }
  /// Announce a technique that lights surfaces by the environment's light, with its visibility.
  void AnnounceSkyLight() { this->SkyAnnounced = true; }
  /// Whether that technique lights this frame. All other indirect light then leaves out what arrives straight from the
  /// environment. Light that was baked contains it: where bakes light the space, and where rays draw the picture, the
  /// technique rests.
  bool LightsSky() const
  {
    return this->SkyAnnounced && !this->ByRays && !this->HasKind(IndirectKind::BakedProbes);
  }
  /// Whether a technique adds light that surfaces reflect onto each other.
  bool KnowsReflectedLight() const { return !this->Indirect.empty(); }
  bool HasKind(IndirectKind kind) const
  {
    return std::any_of(this->Indirect.begin(), this->Indirect.end(),
      [kind](const Source& source) { return source.Kind == kind; });
  }
  /// Whether any of it is known in space, not only on surfaces.
  bool HasLightInSpace() const
  {
    return std::any_of(this->Indirect.begin(), this->Indirect.end(),
      [](const Source& source) {
        return source.Kind == IndirectKind::LiveProbes || source.Kind == IndirectKind::BakedProbes;
      });
  }
  /// The coarsest detail of all indirect light; infinity if there is none; 0 if there is true visibility, which nothing
  /// may darken.
  double IndirectDetail() const
  {
    if (this->LightsSky() || this->HasKind(IndirectKind::Rays))
    {
      return 0.0;
    }
    double detail = this->Indirect.empty() ? std::numeric_limits<double>::infinity() : 0.0;
    for (const Source& source : this->Indirect)
    {
      detail = std::max(detail, source.Detail);
    }
    return detail;
  }

  /// Ask for a technique whose light follows the scene, because a bake no longer fits.
  void RequestLiveLight() { this->LiveLightRequested = true; }
  bool NeedsLiveLight() const
  {
    return this->LiveLightRequested && !this->HasLightInSpace() &&
      !this->HasKind(IndirectKind::BakedOnSurfaces) && !this->ByRays;
  }

  /// Rays draw everything that they see, including translucent props, and average still frames themselves.
  void DrawByRays() { this->ByRays = true; }
  bool IsDrawnByRays() const { return this->ByRays; }

  /// Announce that a technique filters noise.
  void FilterNoise() { this->NoiseFiltered = true; }
  bool FiltersNoise() const { return this->NoiseFiltered; }

  /// Announce that a technique maps the linear values of lit surfaces to the display.
  void MapTones() { this->TonesMapped = true; }
  /// If they are mapped, have them kept apart until then (resource::LitShown, resource::LitEncoded), because passes after
  /// the direct light need them.
  void KeepLitParts() { this->LitPartsKept = true; }
  /// Whether they are kept apart. If not, direct light maps what it draws.
  bool HasLitParts() const { return this->TonesMapped && (this->LitPartsKept || this->ByRays); }

  /// Rules of reflection that hold for all surfaces of the frame.
  SurfaceRules& Rules() { return this->ReflectionRules; }
  const SurfaceRules& Rules() const { return this->ReflectionRules; }

private:
  struct Source
  {
    IndirectKind Kind;
    double Detail;
  };
  std::vector<Source> Indirect;
  double Share = 0.0;
  double InterreflectionShare = 0.0;
  bool LiveLightRequested = false;
  bool SkyAnnounced = false;
  bool ByRays = false;
  bool NoiseFiltered = false;
  bool TonesMapped = false;
  bool LitPartsKept = false;
  SurfaceRules ReflectionRules;
};
}
