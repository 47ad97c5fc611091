// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light in real spherical harmonics of the bands 0 to 2, in the order of glsl/lib/spherical_harmonics.glsl.
 */
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace penumbra
{
using Harmonics = std::array<double, 9>;

/// The values of all nine in a unit direction.
Harmonics HarmonicsOf(const glm::dvec3& direction);

/// The band of a coefficient: 0, 1 or 2.
int HarmonicBand(int index);

/// The zonal coefficient of band l of the clamped cosine, by which radiance's coefficients are multiplied to become
/// irradiance's (Ramamoorthi and Hanrahan 2001, On the Relationship between Radiance and Irradiance).
double CosineKernel(int band);

/// A colour's harmonics, three numbers a coefficient: radiance to irradiance divided by pi.
void ToIrradiance(float* colors);

/// Smooth irradiance as little as it takes for it not to fall below zero in any direction, all colours alike. The
/// window is the one that makes the squared Laplacian small (Sloan 2008, Stupid Spherical Harmonics (SH) Tricks);
/// the mean stays. Returns its strength, 0 where nothing had to be done.
double WindowHarmonics(float* colors);
}
