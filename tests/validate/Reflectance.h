// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// How much of uniform light the surface models of VTK reflect toward one direction: integrals over
// the hemisphere by the midpoint rule, written apart from the shaders.
#pragma once

namespace validate
{
/// Diffuse and specular reflectance and the highlight's power as VTK draws Phong: the highlight
/// has neither a factor of normalization nor the light's cosine.
double PhongAlbedo(double diffuse, double specular, double power, double cosView);

/// The metallic-roughness model as VTK draws it, index of refraction 1.5, white edge tint.
double PhysicalAlbedo(double color, double metallic, double roughness, double cosView);
}
