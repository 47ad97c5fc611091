// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Coverage of a pixel by the surfaces around it. Each of its samples takes the colour of one of 3 x 3 pixels, whose index, row by
// row, is stored in four bits.
const int COVERAGE_SAMPLES = 4;
const uint COVERAGE_BITS = 4u;
const uint COVERAGE_OWN = 4u;
const uint COVERAGE_OWN_ONLY = 0x4444u;    // no edge
const uint COVERAGE_UNKNOWN = 0xffffffffu; // lines, points or other untraced surfaces nearby

bool isShared(uint coverage)
{
  return coverage != COVERAGE_OWN_ONLY && coverage != COVERAGE_UNKNOWN;
}

uint sourceOf(ivec2 offset)
{
  return uint(offset.x + 1 + 3 * (offset.y + 1));
}

ivec2 sampleOffset(uint coverage, int number)
{
  int source = int(bitfieldExtract(coverage, number * int(COVERAGE_BITS), int(COVERAGE_BITS)));
  return ivec2(source % 3, source / 3) - 1;
}
