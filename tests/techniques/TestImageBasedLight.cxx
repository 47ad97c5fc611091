// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Image-based light is the same whoever gathers it: VTK, probes or paths.
 */
#include "EnvironmentStage.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr double Radiance = 0.5; // of the furnace
}

// Uniform surroundings: each ball is of one colour, and the same in every preset.
TEST(ImageBasedLight, BallsInAFurnace)
{
  EnvironmentStage stage;
  stage.SetEnvironment(EvenTexture<float>(Radiance));
  const auto balls =
    stage.AddBalls({ { 0.0, 0.5 }, { 0.0, 0.1 }, { 1.0, 0.0 }, { 1.0, 0.35 }, { 1.0, 1.0 } });
  const auto stock = stage.Measure("stock", 1);
  // While probes are updated, which is before the capture.
  const auto high = stage.Measure("high", 3);
  const auto reference = stage.Measure("reference", 64);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    std::printf("metallic %.0f, roughness %.2f: stock %.1f +- %.1f, high %.1f +- %.1f, "
                "reference %.1f +- %.1f\n",
      balls[i].Metallic, balls[i].Roughness, stock[i].Mean, stock[i].Deviation, high[i].Mean,
      high[i].Deviation, reference[i].Mean, reference[i].Deviation);
    EXPECT_GT(stock[i].Mean, 80.0);
    EXPECT_NEAR(high[i].Mean, stock[i].Mean, 3.0);
    EXPECT_NEAR(reference[i].Mean, stock[i].Mean, 3.0);
    EXPECT_LE(high[i].Deviation, 4.0);
    EXPECT_LE(reference[i].Deviation, 4.0);
  }
}

// Translucent surfaces are drawn by VTK after the passes, with the textures of its image-based light.
TEST(ImageBasedLight, TranslucentBallsInAFurnace)
{
  EnvironmentStage stage;
  stage.SetEnvironment(EvenTexture<float>(Radiance));
  const auto balls = stage.AddBalls({ { 0.0, 0.5 }, { 1.0, 0.0 }, { 1.0, 1.0 } }, 0.999);
  const auto stock = stage.Measure("stock", 1);
  const auto high = stage.Measure("high", 3);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    std::printf("metallic %.0f, roughness %.2f: stock %.1f, high %.1f +- %.1f\n", balls[i].Metallic,
      balls[i].Roughness, stock[i].Mean, high[i].Mean, high[i].Deviation);
    EXPECT_NEAR(high[i].Mean, stock[i].Mean, 3.0);
    EXPECT_LE(high[i].Deviation, 4.0);
  }
}
