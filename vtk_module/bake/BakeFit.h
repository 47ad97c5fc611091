// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a technique's baked light may be shown in a view, and what the user is told where not.
 */
#pragma once

#include "bake/BakedScene.h"

namespace penumbra
{
class FrameBuilder;
class LightingPlan;

/// A bake's scene beside the one that a view shows, from frame to frame.
class BakeFit
{
public:
  /// Compare a frame's scene with the bake's. Where they differ, a note says so.
  /// complaint: how that begins, as in "the lightmap no longer fits".
  void Check(FrameBuilder& frame, const BakedScene& baked, const std::string& complaint);

  bool Fits() const { return this->Difference.empty(); }
  /// As in "light 1 moved"; "" where the bake fits.
  const std::string& Mismatch() const { return this->Difference; }
  /// Whether nothing is seen through any prop, be it translucent, clipped or culled.
  bool IsSolid() const { return this->Scene.IsSolid(); }

private:
  BakedSceneWatch Scene;
  std::string Difference;
};
}
