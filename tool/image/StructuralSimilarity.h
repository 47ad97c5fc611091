// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Mean SSIM of two pictures' luminance.
#pragma once

#include "image/Picture.h"

namespace penumbra::tool
{
/// Wang, Bovik, Sheikh and Simoncelli 2004, Image Quality Assessment: From Error Visibility to
/// Structural Similarity. Values are taken as display values with a range of 1.
double StructuralSimilarity(const Picture& a, const Picture& b);
}
