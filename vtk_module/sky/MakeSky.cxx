// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sky/MakeSky.h"

#include "sky/Atmosphere.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
void FillGradient(
  SkyImage& sky, const glm::dvec3& zenith, const glm::dvec3& horizon, const glm::dvec3& ground)
{
  sky.Fill([&](const glm::dvec3& direction) {
    return glm::mix(horizon, direction.y > 0.0 ? zenith : ground,
      glm::smoothstep(0.0, 1.0, std::abs(direction.y)));
  });
}

glm::dvec3 FillDaylight(SkyImage& sky, double turbidity, const glm::dvec3& groundAlbedo,
  const glm::dvec3& toSun, double strength)
{
  const Atmosphere air(turbidity, groundAlbedo);
  const double sunlight = strength * glm::pi<double>(); // irradiance above the atmosphere
  sky.Fill([&](const glm::dvec3& direction) {
    return direction.y > 0.0 ? sunlight * air.Radiance(direction, toSun) : glm::dvec3(0.0);
  });
  const glm::dvec3 sun = air.SunAtGround(toSun.y);
  const glm::dvec3 irradiance =
    sky.Irradiance({ 0.0, 1.0, 0.0 }) + sunlight * std::max(0.0, toSun.y) * sun;
  const glm::vec3 ground(groundAlbedo * irradiance / glm::pi<double>());
  sky.FillBelow(ground);
  return sun;
}
}
