// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Sample points of glsl/lib/sequence.glsl: how evenly they are distributed.
#include "ComputeHarness.h"

namespace penumbra_test
{
namespace
{
/// Whether each elementary interval of the unit square holds one of 2^bits points: whether they are a (0, bits, 2)-net
/// (Niederreiter 1987, Point sets and sequences with small discrepancy).
bool IsNet(const std::vector<glm::vec2>& points, int bits)
{
  for (int columns = 0; columns <= bits; ++columns)
  {
    const int rows = bits - columns;
    std::vector<bool> taken(points.size());
    for (const glm::vec2& point : points)
    {
      const auto x = static_cast<std::size_t>(point.x * static_cast<float>(1 << columns));
      const auto y = static_cast<std::size_t>(point.y * static_cast<float>(1 << rows));
      const std::size_t cell = y << columns | x;
      if (cell >= taken.size() || taken[cell])
      {
        return false;
      }
      taken[cell] = true;
    }
  }
  return true;
}

constexpr int Width = 4;    // of a tile of pixels that share a sequence
constexpr int Longest = 12; // bits of the number of points of a pixel that is tested

/// Points of a tile's pixels, each pixel's one after the other.
struct TilePoints
{
  std::vector<glm::vec4> Points;

  glm::vec2 At(int pixel, int index) const
  {
    return glm::vec2(this->Points[static_cast<std::size_t>((pixel << Longest) + index)]);
  }
};

class Sequence : public ComputeHarness
{
protected:
  TilePoints PointsOf(glm::ivec2 tile, int seed)
  {
    std::vector<glm::vec4> inputs;
    for (int pixel = 0; pixel < Width * Width; ++pixel)
    {
      for (int index = 0; index < 1 << Longest; ++index)
      {
        inputs.emplace_back(
          Width * tile.x + pixel % Width, Width * tile.y + pixel / Width, index, seed);
      }
    }
    return { this->Run({ "lib/sequence.glsl" },
      "RESULT = vec4(giTileSample2D(uint(IN(0).z), ivec2(IN(0).xy), uint(IN(0).w)), 0.0, 0.0);", 1,
      inputs) };
  }
};

TEST_F(Sequence, EachPixelsPointsAreEven)
{
  const TilePoints points = this->PointsOf({ 5, 130 }, 3);
  for (int pixel = 0; pixel < Width * Width; ++pixel)
  {
    for (int bits = 0; bits <= Longest; ++bits)
    {
      for (int first = 0; first < 1 << Longest; first += 1 << bits)
      {
        std::vector<glm::vec2> some;
        for (int i = 0; i < 1 << bits; ++i)
        {
          some.push_back(points.At(pixel, first + i));
        }
        ASSERT_TRUE(IsNet(some, bits))
          << some.size() << " points from " << first << " of pixel " << pixel;
      }
    }
  }
}

TEST_F(Sequence, ATilesPointsAreEven)
{
  const TilePoints points = this->PointsOf({ 12, 7 }, 0);
  for (int bits = 0; bits <= Longest; ++bits)
  {
    for (int first = 0; first < 1 << Longest; first += 1 << bits)
    {
      std::vector<glm::vec2> some;
      for (int i = 0; i < Width * Width << bits; ++i)
      {
        some.push_back(points.At(i % (Width * Width), first + i / (Width * Width)));
      }
      ASSERT_TRUE(IsNet(some, bits + 4)) << (1 << bits) << " frames from " << first;
    }
  }
}

TEST_F(Sequence, TilesAndSeedsDiffer)
{
  const TilePoints points = this->PointsOf({ 12, 7 }, 0);
  for (const TilePoints& other : { this->PointsOf({ 13, 7 }, 0), this->PointsOf({ 12, 7 }, 1) })
  {
    int same = 0;
    for (int i = 0; i < 1 << Longest; ++i)
    {
      same += points.At(0, i) == other.At(0, i);
    }
    EXPECT_LE(same, 1);
  }
}
}
}
