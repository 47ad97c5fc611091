// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// ITU-R BT.709, of linear colours.
float giLuminance(vec3 color)
{
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}
