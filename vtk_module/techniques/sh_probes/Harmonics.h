// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light in real spherical harmonics of bands 0 to 2, in the order of glsl/lib/spherical_harmonics.glsl.
 */
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace penumbra
{
using Harmonics = std::array<double, 9>;

/// The values of all nine basis functions in a unit direction.
Harmonics HarmonicsOf(const glm::dvec3& direction);

/// The band of a coefficient: 0, 1 or 2.
int HarmonicBand(int index);

/// The zonal coefficient of the clamped cosine in a band: the factor from coefficients of radiance to those of
/// irradiance (Ramamoorthi and Hanrahan 2001, On the Relationship between Radiance and Irradiance).
double CosineKernel(int band);

/// Convert harmonics of radiance, three colour channels per coefficient, to irradiance divided by pi.
void ToIrradiance(float* colors);

/// Smooth irradiance just enough that it is not negative in any direction, by the same window for all channels. The
/// window reduces the squared Laplacian and keeps the mean (Sloan 2008, Stupid Spherical Harmonics (SH) Tricks).
/// Returns its strength, 0 if no smoothing is needed.
double WindowHarmonics(float* colors);
}
