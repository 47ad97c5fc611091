// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Coverage of a pixel by the surfaces around it. Each of its samples takes the colour of one of 3 x 3 pixels, whose index, row by
// row, is stored in four bits of r, times a gain, whose square root is stored in a byte of g. Above the indices r has a bit for each
// sample that is set if VTK encodes its colour for display.
const int COVERAGE_SAMPLES = 4;
const int COVERAGE_SOURCE_BITS = 4;
const int COVERAGE_GAIN_BITS = 8;
const float COVERAGE_UNIT = 85.0; // stored square root of a gain of 1
const float COVERAGE_ENCODING = 2.2;
const uint COVERAGE_OWN = 4u;
const uint COVERAGE_OWN_ONLY = 0x4444u;    // no edge
const uint COVERAGE_NO_GAIN = 0x55555555u; // all gains are 1
const uint COVERAGE_UNKNOWN = 0xffffffffu; // lines, points or other untraced surfaces nearby

bool isShared(uvec2 coverage)
{
  return coverage.r != COVERAGE_UNKNOWN && coverage != uvec2(COVERAGE_OWN_ONLY, COVERAGE_NO_GAIN);
}

uint sourceOf(ivec2 offset)
{
  return uint(offset.x + 1 + 3 * (offset.y + 1));
}

ivec2 sampleOffset(uvec2 coverage, int number)
{
  int source = int(bitfieldExtract(coverage.r, number * COVERAGE_SOURCE_BITS, COVERAGE_SOURCE_BITS));
  return ivec2(source % 3, source / 3) - 1;
}

// Factor of a sample's radiance, or of its colour for display.
float sampleGain(uvec2 coverage, int number, bool display)
{
  float root = float(bitfieldExtract(coverage.g, number * COVERAGE_GAIN_BITS, COVERAGE_GAIN_BITS)) / COVERAGE_UNIT;
  bool encoded = bitfieldExtract(coverage.r, COVERAGE_SAMPLES * COVERAGE_SOURCE_BITS + number, 1) != 0u;
  return pow(root, encoded && display ? 2.0 / COVERAGE_ENCODING : 2.0);
}

// A sample in the fewest bits.
uint coverageSample(uint source, float gain, bool encoded)
{
  uint root = uint(clamp(sqrt(gain) * COVERAGE_UNIT + 0.5, 0.0, 255.0));
  return source | root << COVERAGE_SOURCE_BITS | (encoded ? 1u << (COVERAGE_SOURCE_BITS + COVERAGE_GAIN_BITS) : 0u);
}

void setSample(inout uvec2 coverage, int number, uint found)
{
  uint root = found >> COVERAGE_SOURCE_BITS;
  coverage.r = bitfieldInsert(coverage.r, found, number * COVERAGE_SOURCE_BITS, COVERAGE_SOURCE_BITS);
  coverage.r = bitfieldInsert(coverage.r, root >> COVERAGE_GAIN_BITS, COVERAGE_SAMPLES * COVERAGE_SOURCE_BITS + number, 1);
  coverage.g = bitfieldInsert(coverage.g, root, number * COVERAGE_GAIN_BITS, COVERAGE_GAIN_BITS);
}
