// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Luminance of a linear colour (ITU-R BT.709).
float giLuminance(vec3 color)
{
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}
