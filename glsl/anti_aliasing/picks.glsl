// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Of each point of a pixel at an edge, the pixel around it whose colour the point has: four bits per point, the place
// among 3 x 3 pixels, row by row.
const int PICK_POINTS = 4;
const uint PICK_BITS = 4u;
const uint PICK_OWN = 4u;
const uint PICK_ALL_OWN = 0x4444u;
const uint PICK_UNKNOWN = 0xffffffffu; // all own, as rays do not see everything there

bool hasPicks(uint picks)
{
  return picks != PICK_ALL_OWN && picks != PICK_UNKNOWN;
}

uint pickOf(ivec2 offset)
{
  return uint(offset.x + 1 + 3 * (offset.y + 1));
}

ivec2 offsetOfPick(uint picks, int point)
{
  int pick = int(bitfieldExtract(picks, point * int(PICK_BITS), int(PICK_BITS)));
  return ivec2(pick % 3, pick / 3) - 1;
}
