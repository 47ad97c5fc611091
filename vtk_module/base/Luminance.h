// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Luminance of linear colours (ITU-R BT.709).
 */
#pragma once

namespace penumbra
{
inline double Luminance(double red, double green, double blue)
{
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
}
