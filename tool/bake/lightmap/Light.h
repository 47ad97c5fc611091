// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Light in the texels of an atlas, and filters for it.
#pragma once

#include "bake/lightmap/Texels.h"
#include "image/Picture.h"

namespace penumbra::lightmap
{
/// Irradiance divided by pi, and for directional maps nine more channels.
using Light = tool::Picture;

/// Bilinear interpolation, as on the graphics card. Integers are the centres of texels.
double Sample(const Light& light, const Vec2& at, int channel);

/// Fills texels without a value (known is 0) with the mean of their neighbours, from the inside out, within tiles and their
/// gutters.
void Dilate(Light& light, std::vector<unsigned char>& known, const Atlas& atlas);

/// Equalizes the interpolated light on both sides of seams: least squares of the differences at seams, and of the changes of
/// texels (Iwanicki 2013, Lighting Technology of The Last of Us). fixed: nonzero for texels that must not change. Seams
/// between those are already closed, and closing them again would change their light.
void CloseSeams(
  Light& light, const std::vector<SeamLine>& lines, const std::vector<unsigned char>& fixed = {});

/// The greatest difference across seams, relative to the light there, or to a tenth of the mean at seams if that is more.
double SeamStep(const Light& light, const std::vector<SeamLine>& lines);

/// Removes noise from the mean of two halves of the samples, within tiles. Each half determines which texels of the other
/// are similar (Rousselle, Knaus and Zwicker 2012, Adaptive Rendering with Non-Local Means Filtering).
/// known: texels with a value.
Light Denoise(const Light& first, const Light& second, const std::vector<unsigned char>& known,
  const std::vector<Texel>& texels, const Atlas& atlas);
}
