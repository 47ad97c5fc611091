// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow cascades: fine near the camera, stable while it moves, and complete.
#include "graph/View.h"
#include "light/LightTable.h"
#include "shadows/ShadowAtlas.h"
#include "techniques/shadow_maps/ShadowCascades.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cstdio>

namespace
{
using namespace penumbra;

// A scene a hundred times as deep as wide.
const Bounds Corridor = { { -5.0, 5.0, 0.0, 1000.0, 0.0, 3.0 } };
const CascadeOptions Options = { 4, 2048, 3.5, 0.95 };

Light Sun()
{
  Light light;
  light.Color = glm::dvec3(1.0);
  light.WorldDirection = glm::normalize(glm::dvec3(0.5, 0.3, -1.0));
  return light;
}

View Look(const glm::dvec3& from, const glm::dvec3& to, const Bounds& bounds)
{
  View view;
  view.Viewport = { 0, 0, 1280, 720 };
  view.WorldToView = glm::lookAt(from, to, glm::dvec3(0.0, 0.0, 1.0));
  view.ViewToWorld = glm::inverse(view.WorldToView);
  view.ViewToClip = glm::perspective(glm::radians(30.0), 16.0 / 9.0, 0.1, 2000.0);
  view.Bounds = bounds;
  view.Diagonal = 1.0;
  return view;
}

std::vector<ShadowView> Maps(const View& view)
{
  std::vector<ShadowView> maps;
  for (const auto& sphere : ChooseCascades(Sun(), view, Options).Spheres)
  {
    maps.push_back(
      FitShadowSphere(Sun(), view.Bounds, sphere, Options.Resolution / 2, Options.Margin));
  }
  return maps;
}

// Position of a world point between the texels of a map.
glm::dvec2 Fraction(const ShadowView& map, const glm::dvec3& point)
{
  const glm::dvec4 clip = map.ViewToClip * map.WorldToView * glm::dvec4(point, 1.0);
  const glm::dvec2 texel = (glm::dvec2(clip) * 0.5 + 0.5) * (Options.Resolution / 2.0);
  return texel - glm::floor(texel);
}

// Shift between the texel grids of two maps, in texels.
double Shift(const ShadowView& a, const ShadowView& b)
{
  const glm::dvec3 point(1.234, 20.5, 0.77);
  const glm::dvec2 d = Fraction(a, point) - Fraction(b, point);
  const glm::dvec2 wrapped = d - glm::round(d);
  return std::max(std::abs(wrapped.x), std::abs(wrapped.y));
}

TEST(ShadowCascades, TexelsNearTheCameraAreAtLeastFourTimesFinerAtEqualMemory)
{
  const View view = Look({ 0.0, -1.0, 1.7 }, { 0.0, 100.0, 1.0 }, Corridor);
  const auto maps = Maps(view);
  ASSERT_GE(maps.size(), 2u);
  ASSERT_LE(maps.size(), 4u); // of half the width each: together the memory of one map
  const double whole = FitShadowViews(Sun(), Corridor, Options.Resolution, Options.Margin)[0].Texel;
  std::printf("one map: texels of %.4f; cascades:", whole);
  for (const auto& map : maps)
  {
    std::printf(" %.4f (%.1f times finer)", map.Texel, whole / map.Texel);
  }
  std::printf("\n");
  EXPECT_GE(whole / maps[0].Texel, 4.0);
}

TEST(ShadowCascades, TexelGridsAreStableWhileTheCameraMovesAndTurns)
{
  const glm::dvec3 from(0.0, 5.0, 1.7);
  const View start = Look(from, from + glm::dvec3(0.0, 1.0, 0.0), Corridor);
  const auto before = Maps(start);
  const double step = 0.37 * before[0].Texel;
  double worst = 0.0;
  int redrawn = 0;
  auto last = before;
  for (int i = 1; i <= 400; ++i)
  {
    const int move = std::min(i, 200);
    const double turn = glm::radians(0.11 * std::max(0, i - 200));
    const glm::dvec3 at = from + move * step * glm::normalize(glm::dvec3(0.8, 0.5, 0.3));
    const View view =
      Look(at, at + glm::dvec3(std::sin(turn), std::cos(turn), -0.2 * std::sin(turn)), Corridor);
    const auto maps = Maps(view);
    ASSERT_EQ(maps.size(), before.size());
    for (std::size_t k = 0; k < maps.size(); ++k)
    {
      EXPECT_EQ(maps[k].Texel, before[k].Texel) << "frame " << i << ", cascade " << k;
      EXPECT_EQ(maps[k].Near, before[k].Near);
      worst = std::max(worst, Shift(maps[k], before[k]));
      redrawn += maps[k].WorldToView != last[k].WorldToView;
    }
    last = maps;
  }
  std::printf("200 translations, 200 turns: grids shifted by %.2g texels, %d of %zu maps redrawn\n",
    worst, redrawn, 400 * before.size());
  EXPECT_LT(worst, 1e-6);
}

TEST(ShadowCascades, CoverAllVisiblePoints)
{
  for (const glm::dvec3& from :
    { glm::dvec3(0.0, -1.0, 1.7), glm::dvec3(30.0, -20.0, 15.0), glm::dvec3(2.0, 500.0, 1.0) })
  {
    const View view = Look(from, { 1.0, 300.0, 1.0 }, Corridor);
    const ShadowCascades cascades = ChooseCascades(Sun(), view, Options);
    const auto maps = Maps(view);
    int visible = 0;
    for (int i = 0; i < 40000; ++i)
    {
      const glm::dvec3 point(-5.0 + 10.0 * (i % 10) / 9.0, 1000.0 * std::pow(i / 40000.0, 3.0),
        3.0 * (i / 10 % 4) / 3.0);
      const glm::dvec4 clip = view.ViewToClip * view.WorldToView * glm::dvec4(point, 1.0);
      if (clip.w <= 0.0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w)
      {
        continue;
      }
      ++visible;
      const double distance = glm::length(point - from);
      std::size_t k = 0;
      while (k + 1 < cascades.Ends.size() && distance > cascades.Ends[k])
      {
        ++k;
      }
      const glm::dvec4 there = maps[k].ViewToClip * maps[k].WorldToView * glm::dvec4(point, 1.0);
      EXPECT_LT(std::max({ std::abs(there.x), std::abs(there.y), std::abs(there.z) }), 1.0)
        << "cascade " << k << ", distance " << distance;
    }
    EXPECT_GT(visible, 100);
  }
}

TEST(ShadowCascades, OneMapIfTheSceneIsAsDeepAsWide)
{
  const Bounds head = { { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 } };
  for (double angle = 0.0; angle < 6.2; angle += 0.3)
  {
    const View view =
      Look({ 7.0 * std::cos(angle), 7.0 * std::sin(angle), 2.0 }, { 0.0, 0.0, 0.0 }, head);
    EXPECT_TRUE(ChooseCascades(Sun(), view, Options).Spheres.empty()) << angle;
  }
}

// No two tiles of an atlas overlap, and all lie inside it.
TEST(ShadowAtlas, TilesDoNotOverlap)
{
  for (const int largest : { 100, 64, 2048 })
  {
    const std::vector<int> halvings = { 1, 0, 3, 1, 1, 2, 0, 3, 3, 1, 2, 2, 1, 0, 3, 3, 3, 3, 3 };
    const ShadowAtlas atlas = PackShadowAtlas(largest, halvings);
    ASSERT_EQ(atlas.Tiles.size(), halvings.size());
    for (std::size_t i = 0; i < atlas.Tiles.size(); ++i)
    {
      const AtlasTile& a = atlas.Tiles[i];
      EXPECT_GE(std::min(a.X, a.Y), 0);
      EXPECT_LE(a.X + a.Size, atlas.Width);
      EXPECT_LE(a.Y + a.Size, atlas.Height);
      EXPECT_NEAR(a.Size, largest >> halvings[i], 1 << (3 - halvings[i]));
      for (std::size_t k = 0; k < i; ++k)
      {
        const AtlasTile& b = atlas.Tiles[k];
        EXPECT_TRUE(
          a.X >= b.X + b.Size || b.X >= a.X + a.Size || a.Y >= b.Y + b.Size || b.Y >= a.Y + a.Size)
          << i << " and " << k;
      }
    }
  }
}

TEST(ShadowAtlas, IsDistributedByImportance)
{
  // All maps fit.
  EXPECT_EQ(
    DistributeShadowAtlas({ { 1, 0, 1.0 }, { 6, 1, 1.0 } }, 3.0, 4), (std::vector<int>{ 0, 1 }));
  // The weaker light's map is made smaller.
  EXPECT_EQ(
    DistributeShadowAtlas({ { 1, 0, 1.0 }, { 1, 0, 0.3 } }, 1.5, 4), (std::vector<int>{ 0, 1 }));
  // Not all of the maps fit, even at the smallest size.
  EXPECT_EQ(DistributeShadowAtlas({ { 1, 0, 1.0 }, { 1, 0, 1.0 }, { 1, 0, 1.0 } }, 0.6, 1),
    (std::vector<int>{ 1, 1 }));
}
}
