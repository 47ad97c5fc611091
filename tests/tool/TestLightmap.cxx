// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Lightmaps without a context: charts do not overlap, tiles do not share texels, seams close, noise falls.
#include "LightmapScenes.h"

#include "bake/lightmap/Overlap.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <set>

using namespace penumbra_test;

namespace
{
/// Pairs of triangles of the chart that overlap in its plane: none, as MakeCharts() leaves it.
std::size_t CountOverlaps(const Surfaces& surfaces, const Chart& chart)
{
  constexpr double rounding = 1e-9;
  constexpr double cells = 256.0;
  const double extent = std::max(chart.Size.x, chart.Size.y);
  FlatSet taken(extent / cells, rounding * extent);
  std::size_t overlaps = 0;
  for (const std::uint32_t t : chart.Triangles)
  {
    const auto& p = surfaces.Triangles[t].Points;
    const Flat flat = { chart.Project(surfaces.Points[p[0]]), chart.Project(surfaces.Points[p[1]]),
      chart.Project(surfaces.Points[p[2]]) };
    overlaps += taken.CountHits(flat);
    taken.Add(flat);
  }
  return overlaps;
}

// A strip that winds upward around an axis, flat enough everywhere to be one chart: its turns cover each other.
Surfaces Spiral()
{
  Surfaces surfaces;
  constexpr int steps = 96; // three turns
  const auto at = [](int i, double radius) {
    const double angle = 6.0 * glm::pi<double>() * i / steps;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.01 * i);
  };
  for (int i = 0; i < steps; ++i)
  {
    const Vec3 a = at(i, 1.0), b = at(i, 2.0), c = at(i + 1, 2.0), d = at(i + 1, 1.0);
    const std::array<Vec3, 3> none{};
    surfaces.Add({ a, b, c }, none, 0);
    surfaces.Add({ a, c, d }, none, 0);
  }
  return surfaces;
}

std::size_t CountTriangles(const std::vector<Chart>& charts)
{
  std::set<std::uint32_t> seen;
  for (const Chart& chart : charts)
  {
    seen.insert(chart.Triangles.begin(), chart.Triangles.end());
  }
  return seen.size();
}
}

TEST(Lightmap, ABoxIsSixCharts)
{
  Scene scene;
  scene.AddBox();
  const Surfaces surfaces = GatherSurfaces(scene.Renderer);
  const std::vector<Chart> charts = MakeCharts(surfaces);
  ASSERT_EQ(charts.size(), 6u);
  double area = 0.0;
  for (const Chart& chart : charts)
  {
    EXPECT_EQ(chart.Triangles.size(), 2u);
    area += chart.Size.x * chart.Size.y;
  }
  EXPECT_NEAR(area, 10.0, 1e-9) << "boxes around charts lie along their edges";
  EXPECT_TRUE(FindSeams(surfaces, charts).empty());
}

TEST(Lightmap, ChartsNeverOverlap)
{
  Scene scene;
  scene.AddTorus();
  scene.AddSphere();
  for (const Surfaces& surfaces : { GatherSurfaces(scene.Renderer), Spiral() })
  {
    const std::vector<Chart> charts = MakeCharts(surfaces);
    EXPECT_EQ(CountTriangles(charts), surfaces.Triangles.size());
    std::size_t overlaps = 0;
    double leanest = 1.0;
    for (const Chart& chart : charts)
    {
      overlaps += CountOverlaps(surfaces, chart);
      for (const std::uint32_t t : chart.Triangles)
      {
        leanest = std::min(leanest, glm::dot(surfaces.Triangles[t].Normal, chart.Normal));
      }
    }
    std::printf("%zu triangles in %zu charts, %zu overlaps, shortened to %.2f at most\n",
      surfaces.Triangles.size(), charts.size(), overlaps, leanest);
    EXPECT_EQ(overlaps, 0u);
    EXPECT_GT(leanest, std::cos(glm::radians(55.0)));
    EXPECT_LT(charts.size(), surfaces.Triangles.size() / 30);
  }
  // As one chart the spiral's turns would: the count sees them.
  const Surfaces spiral = Spiral();
  Chart whole = MakeCharts(spiral).front();
  for (std::uint32_t t = 0; t < spiral.Triangles.size(); ++t)
  {
    whole.Triangles.push_back(t);
  }
  EXPECT_GT(CountOverlaps(spiral, whole), 100u);
}

// What interpolation at any point of a triangle fetches belongs to its tile alone.
TEST(Lightmap, TilesShareNoTexels)
{
  Scene scene;
  scene.AddTorus();
  scene.AddSphere();
  scene.AddBox()->SetPosition(3.0, 0.0, 0.0);
  const Surfaces surfaces = GatherSurfaces(scene.Renderer);
  const std::vector<Chart> charts = MakeCharts(surfaces);
  const Atlas atlas = PackAll(charts, 0.04);
  std::vector<int> owner(std::size_t(atlas.Width) * atlas.Height, -1);
  std::size_t shared = 0, missing = 0, used = 0;
  std::set<std::uint32_t> placed;
  for (const Texel& texel : PlaceTexels(surfaces, charts, atlas))
  {
    placed.insert(texel.Index);
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit;
  for (int i = 0; i < int(atlas.Tiles.size()); ++i)
  {
    const Tile& tile = atlas.Tiles[i];
    for (int y = tile.At.y - Atlas::Gutter; y < tile.At.y + tile.Texels.y + Atlas::Gutter; ++y)
    {
      for (int x = tile.At.x - Atlas::Gutter; x < tile.At.x + tile.Texels.x + Atlas::Gutter; ++x)
      {
        ASSERT_TRUE(x >= 0 && y >= 0 && x < atlas.Width && y < atlas.Height);
        int& own = owner[std::size_t(y) * atlas.Width + x];
        shared += own >= 0 ? 1 : 0;
        own = i;
        ++used;
      }
    }
    for (const std::uint32_t t : charts[tile.Chart].Triangles)
    {
      for (int k = 0; k < 40; ++k)
      {
        // Corners and edges too.
        Vec3 share(unit(random), unit(random), unit(random));
        share = k < 12 ? share * Vec3(k % 2, (k / 2) % 2, 1.0) : share;
        share /= share.x + share.y + share.z;
        Vec3 at(0.0);
        for (int c = 0; c < 3; ++c)
        {
          at += share[c] * surfaces.Points[surfaces.Triangles[t].Points[c]];
        }
        const Chart& chart = charts[tile.Chart];
        const Vec2 there = tile.ToTexels(chart, chart.Project(at)) + Vec2(tile.At);
        for (int tap = 0; tap < 4; ++tap)
        {
          const glm::ivec2 texel = glm::ivec2(glm::floor(there)) + glm::ivec2(tap & 1, tap >> 1);
          const Vec2 off = glm::abs(there - Vec2(texel));
          const bool counts = off.x < 1.0 - 1e-9 && off.y < 1.0 - 1e-9;
          missing += counts && placed.count(texel.y * atlas.Width + texel.x) == 0 ? 1 : 0;
          EXPECT_TRUE(!counts || owner[std::size_t(texel.y) * atlas.Width + texel.x] == i);
        }
      }
    }
  }
  std::printf("%d x %d texels, %.0f %% of them in tiles\n", atlas.Width, atlas.Height,
    100.0 * double(used) / double(owner.size()));
  EXPECT_EQ(shared, 0u);
  EXPECT_EQ(missing, 0u);
  EXPECT_GT(double(used), 0.6 * double(owner.size()));
}

TEST(Lightmap, TexelsLieOnTheSurface)
{
  Scene scene;
  scene.AddSphere()->SetPosition(1e6, 0.0, 0.0); // far off: doubles all the way
  const Surfaces surfaces = GatherSurfaces(scene.Renderer);
  const std::vector<Chart> charts = MakeCharts(surfaces);
  const Atlas atlas = PackAll(charts, 0.05);
  double least = 1e9, most = 0.0;
  for (const Texel& texel : PlaceTexels(surfaces, charts, atlas))
  {
    const Vec3 out = texel.At - Vec3(1e6, 0.0, 0.0);
    const bool back = atlas.Tiles[texel.Tile].Back;
    least = std::min(least, glm::length(out));
    most = std::max(most, glm::length(out));
    EXPECT_GT(glm::dot(texel.Normal, glm::normalize(out)) * (back ? -1.0 : 1.0), 0.98);
  }
  // The ball's facets lie up to 1.2 % within it; points of the front are lifted off them.
  EXPECT_GT(least, 0.494);
  EXPECT_LT(most, 0.503);
}

// Points beside the middles are of the same texels, and as far off as asked where the surface is wide enough.
TEST(Lightmap, TexelsHaveOtherPointsToo)
{
  Scene scene;
  scene.AddBox();
  scene.AddSphere();
  const Surfaces surfaces = GatherSurfaces(scene.Renderer);
  const std::vector<Chart> charts = MakeCharts(surfaces);
  constexpr double size = 0.03;
  const Atlas atlas = PackAll(charts, size);
  const std::vector<Texel> middles = PlaceTexels(surfaces, charts, atlas);
  const std::vector<Texel> beside = PlaceTexels(surfaces, charts, atlas, Vec2(0.4, -0.3));
  ASSERT_EQ(beside.size(), middles.size());
  std::size_t off = 0;
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    ASSERT_EQ(beside[i].Index, middles[i].Index);
    ASSERT_EQ(beside[i].Tile, middles[i].Tile);
    const double distance = glm::length(beside[i].At - middles[i].At);
    EXPECT_LT(distance, 2.5 * size) << "slanted, at an edge";
    off += std::abs(distance - 0.5 * atlas.TexelSize) < 0.2 * size ? 1 : 0;
  }
  EXPECT_GT(off, middles.size() * 8 / 10) << "of " << middles.size();
}

TEST(Lightmap, TexelsWidenUntilTheyFit)
{
  Scene scene;
  scene.AddSphere();
  const Surfaces surfaces = GatherSurfaces(scene.Renderer);
  const std::vector<Chart> charts = MakeCharts(surfaces);
  const Atlas atlas = PackAll(charts, 0.0005, 256);
  EXPECT_LE(std::max(atlas.Width, atlas.Height), 256);
  EXPECT_GT(atlas.TexelSize, 0.0005);
  EXPECT_THROW(PackAll(charts, 0.0005, 16), std::runtime_error);
}

TEST(Lightmap, SeamsClose)
{
  Scene scene;
  scene.AddSphere();
  scene.AddTorus();
  const Surfaces surfaces = GatherSurfaces(scene.Renderer);
  const std::vector<Chart> charts = MakeCharts(surfaces);
  const Atlas atlas = PackAll(charts, 0.08);
  const std::vector<Texel> texels = PlaceTexels(surfaces, charts, atlas);
  const auto lines = PlaceSeams(surfaces, charts, atlas, FindSeams(surfaces, charts));
  ASSERT_GT(lines.size(), 100u);
  std::vector<unsigned char> known;
  Light light = Fill(atlas, texels, known);
  // Noise, as a bake leaves it.
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0f, 0.02f);
  for (const Texel& texel : texels)
  {
    for (int c = 0; c < 3; ++c)
    {
      light.Pixel(texel.Index)[c] += noise(random);
    }
  }
  Dilate(light, known, atlas);
  const Light before = light;
  CloseSeams(light, lines);
  double moved = 0.0;
  for (const Texel& texel : texels)
  {
    moved =
      std::max(moved, std::abs(double(light.Pixel(texel.Index)[0]) - before.Pixel(texel.Index)[0]));
  }
  std::printf("step across seams %.4f, closed %.5f; a texel changed by %.3f at most\n",
    SeamStep(before, lines), SeamStep(light, lines), moved);
  EXPECT_GT(SeamStep(before, lines), 0.03);
  EXPECT_LT(SeamStep(light, lines), 0.01);
  EXPECT_LT(moved, 0.3);
}

TEST(Lightmap, NoiseFalls)
{
  Scene scene;
  scene.AddBox();
  const Surfaces surfaces = GatherSurfaces(scene.Renderer);
  const std::vector<Chart> charts = MakeCharts(surfaces);
  const Atlas atlas = PackAll(charts, 0.05);
  const std::vector<Texel> texels = PlaceTexels(surfaces, charts, atlas);
  std::vector<unsigned char> known;
  const Light exact = Fill(atlas, texels, known);
  Light halves[2] = { exact, exact };
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0.0f, 0.1f);
  for (const Texel& texel : texels)
  {
    for (Light& half : halves)
    {
      for (int c = 0; c < 3; ++c)
      {
        half.Pixel(texel.Index)[c] += noise(random);
      }
    }
  }
  const Light denoised = Denoise(halves[0], halves[1], known, texels, atlas);
  double before = 0.0, after = 0.0;
  for (const Texel& texel : texels)
  {
    const float mean = 0.5f * (halves[0].Pixel(texel.Index)[1] + halves[1].Pixel(texel.Index)[1]);
    before += std::pow(mean - exact.Pixel(texel.Index)[1], 2.0);
    after += std::pow(denoised.Pixel(texel.Index)[1] - exact.Pixel(texel.Index)[1], 2.0);
  }
  std::printf("mean squared error %.6f, denoised %.6f\n", before / double(texels.size()),
    after / double(texels.size()));
  EXPECT_LT(after, 0.25 * before);
}
