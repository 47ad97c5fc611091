// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The views of a light contain all occluders.
#include "light/LightTable.h"
#include "shadows/ShadowViews.h"

namespace
{
using namespace penumbra;

const Bounds Box = { { -2.0, 3.0, -1.0, 1.5, 0.0, 4.0 } };

Light MakeLight(bool positional, double cone, const glm::dvec3& position)
{
  Light light;
  light.Color = glm::dvec3(1.0);
  light.Positional = positional;
  light.ConeAngle = cone;
  light.WorldPosition = position;
  light.WorldDirection = glm::normalize(glm::dvec3(0.5, 0.2, 2.0) - position);
  return light;
}

// Number of views that contain a point.
int CountViews(const std::vector<ShadowView>& fitted, const glm::dvec3& point)
{
  int count = 0;
  for (const auto& view : fitted)
  {
    const glm::dvec4 clip = view.ViewToClip * view.WorldToView * glm::dvec4(point, 1.0);
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    count +=
      clip.w > 0.0 && std::abs(ndc.x) <= 1.0 && std::abs(ndc.y) <= 1.0 && std::abs(ndc.z) <= 1.0;
  }
  return count;
}

template <typename Visit>
void ForEachPoint(Visit visit)
{
  for (int i = 0; i < 125; ++i)
  {
    const glm::dvec3 t(i % 5 / 4.0, i / 5 % 5 / 4.0, i / 25 / 4.0);
    visit(glm::dvec3(Box[0] + t.x * (Box[1] - Box[0]), Box[2] + t.y * (Box[3] - Box[2]),
      Box[4] + t.z * (Box[5] - Box[4])));
  }
}

TEST(ShadowViews, DirectionalLightSeesEverything)
{
  for (const glm::dvec3& from : { glm::dvec3(10, 4, 20), glm::dvec3(0.5, 0.2, 30),
         glm::dvec3(0.5, -30, 2), glm::dvec3(-40, 0.2, 2) })
  {
    const auto fitted = FitShadowViews(MakeLight(false, 90.0, from), Box, 1024, 3.5);
    ASSERT_EQ(fitted.size(), 1u);
    EXPECT_TRUE(fitted[0].Parallel);
    EXPECT_GT(fitted[0].Texel, 0.0);
    ForEachPoint([&](const glm::dvec3& p) { EXPECT_EQ(CountViews(fitted, p), 1); });
  }
}

TEST(ShadowViews, OmnidirectionalLightSeesEverything)
{
  for (const glm::dvec3& at : { glm::dvec3(0.4, 0.1, 2.1), glm::dvec3(10, 4, 20) })
  {
    const auto fitted = FitShadowViews(MakeLight(true, 180.0, at), Box, 1024, 3.5);
    // A distant light needs only one map.
    ASSERT_EQ(fitted.size(), at.x > 5.0 ? 1u : 6u);
    EXPECT_EQ(CountShadowViews(MakeLight(true, 180.0, at), Box), static_cast<int>(fitted.size()));
    ForEachPoint([&](const glm::dvec3& p) {
      if (glm::length(p - at) > 0.2)
      {
        EXPECT_GE(CountViews(fitted, p), 1);
      }
    });
  }
}

TEST(ShadowViews, ConeSeesEverythingThatItLights)
{
  const Light light = MakeLight(true, 20.0, glm::dvec3(6, 3, 9));
  const auto fitted = FitShadowViews(light, Box, 1024, 3.5);
  ASSERT_EQ(fitted.size(), 1u);
  EXPECT_FALSE(fitted[0].Parallel);
  int lit = 0;
  ForEachPoint([&](const glm::dvec3& p) {
    const double angle =
      std::acos(glm::dot(glm::normalize(p - light.WorldPosition), light.WorldDirection));
    if (angle < glm::radians(20.0))
    {
      EXPECT_EQ(CountViews(fitted, p), 1);
      ++lit;
    }
  });
  EXPECT_GT(lit, 5);
}
}
