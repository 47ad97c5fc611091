// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tells whether a technique's baked light fits the scene in a view, and notes for the user if it does not.
 */
#pragma once

#include "bake/BakedScene.h"

namespace penumbra
{
class FrameBuilder;
class LightingPlan;

/// Compares the baked scene with the one in a view, from frame to frame.
class BakeFit
{
public:
  /// Compare a frame's scene with the bake's. If they differ, add a note that begins with complaint, for example "the
  /// lightmap no longer fits".
  void Check(FrameBuilder& frame, const BakedScene& baked, const std::string& complaint);

  bool Fits() const { return this->Difference.empty(); }
  /// The difference, such as "light 1 moved"; "" if the bake fits.
  const std::string& Mismatch() const { return this->Difference; }
  /// Whether all props are opaque and complete: none is translucent, clipped or culled.
  bool IsSolid() const { return this->Watch.IsSolid(); }

private:
  BakedSceneWatch Watch;
  std::string Difference;
};
}
