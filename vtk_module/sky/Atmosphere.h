// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light of a clear sky: single scattering along the view ray, and all further scattering as an isotropic field.
 *
 * Hillaire 2020, A Scalable and Production Ready Sky and Atmosphere Rendering Technique. The haze follows from the
 * turbidity. The three channels stand for 680, 550 and 440 nm, as in Bruneton and Neyret 2008, Precomputed Atmospheric
 * Scattering. Sunlight above the atmosphere is white. Results are relative to its irradiance.
 */
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace penumbra
{
class Atmosphere
{
public:
  /// turbidity: optical thickness of the air with its haze over that of the air alone, at 550 nm.
  Atmosphere(double turbidity, const glm::dvec3& groundAlbedo);

  /// Share of the sunlight that reaches the ground, for the sine of the sun's elevation. The disc sets gradually.
  glm::dvec3 SunAtGround(double sinElevation) const;

  /// Radiance from a direction above the horizon, without the sun's disc. Both directions have unit length; y is up.
  glm::dvec3 Radiance(const glm::dvec3& direction, const glm::dvec3& sun) const;

private:
  struct Medium
  {
    glm::dvec3 Rayleigh; ///< scattering coefficients, per kilometre
    glm::dvec3 Haze;
    glm::dvec3 Extinction;
  };
  Medium At(double height) const;
  glm::dvec3 Through(double radius, double cosine) const;      ///< to the top of the atmosphere
  glm::dvec3 SunThrough(double radius, double cosine) const;   ///< 0 in the planet's shadow
  glm::dvec3 Scattered(double radius, double sunCosine) const; ///< light scattered twice or more
  void TabulateTransmittance();
  void TabulateScattering();

  glm::dvec3 Ground;
  glm::dvec3 HazeExtinction; ///< at the ground, per kilometre
  std::vector<glm::dvec3> Transmittance;
  std::vector<glm::dvec3> Multiple;
};
}
