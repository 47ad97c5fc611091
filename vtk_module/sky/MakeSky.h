// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The kinds of sky.
 */
#pragma once

#include "sky/SkyImage.h"

namespace penumbra
{
/// Radiances straight up, level and straight down, blended by smooth steps of the sine of the elevation.
void FillGradient(
  SkyImage& sky, const glm::dvec3& zenith, const glm::dvec3& horizon, const glm::dvec3& ground);

/// A clear sky over ground that sun and sky light. strength: radiance of a white surface that faces the sun above the
/// atmosphere. Returns the share of the sunlight that reaches the ground.
glm::dvec3 FillDaylight(SkyImage& sky, double turbidity, const glm::dvec3& groundAlbedo,
  const glm::dvec3& toSun, double strength);
}
