// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Share of uniform light that VTK's surface models reflect in one direction: integrals over the hemisphere by the
// midpoint rule, implemented independently of the shaders.
#pragma once

namespace validate
{
/// VTK's Phong model, whose highlight has neither a normalization factor nor the light's cosine.
double PhongAlbedo(double diffuse, double specular, double power, double cosView);

/// VTK's metallic-roughness model with index of refraction 1.5 and white edge tint.
double PhysicalAlbedo(double color, double metallic, double roughness, double cosView);
}
