// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Image-based light is the same whoever gathers it: VTK, probes or paths.
 */
#include "EnvironmentStage.h"

#include "rays/RaySky.h"

#include <vtkSkybox.h>
#include <vtkVersion.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr double Radiance = 0.5; // of the furnace

// VTK 9.6.1 and later add to image-based light alone what microfacets send to each other (docs/indirect-light.md): a rough
// metal of stock VTK keeps all light there, and nothing of it for lamps, probes and paths. The other balls are hardly
// touched.
bool ScattersManyTimes(double stockOfRoughMetal)
{
  const bool many = stockOfRoughMetal > 120.0;
  EXPECT_TRUE(!many || VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 1)) << stockOfRoughMetal;
  return many;
}
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
  const bool many = ScattersManyTimes(stock[4].Mean);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    std::printf("metallic %.0f, roughness %.2f: stock %.1f +- %.1f, high %.1f +- %.1f, "
                "reference %.1f +- %.1f\n",
      balls[i].Metallic, balls[i].Roughness, stock[i].Mean, stock[i].Deviation, high[i].Mean,
      high[i].Deviation, reference[i].Mean, reference[i].Deviation);
    EXPECT_GT(stock[i].Mean, 80.0);
    EXPECT_NEAR(high[i].Mean, reference[i].Mean, 3.0);
    if (!many || balls[i].Metallic == 0.0 || balls[i].Roughness < 1.0)
    {
      EXPECT_NEAR(high[i].Mean, stock[i].Mean, many ? 6.0 : 3.0);
      EXPECT_NEAR(reference[i].Mean, stock[i].Mean, many ? 6.0 : 3.0);
    }
    EXPECT_LE(high[i].Deviation, 4.0);
    EXPECT_LE(reference[i].Deviation, 4.0);
  }
}

// What stays bound of a frame's own textures must not pass for what VTK holds: they go as the window changes its size.
TEST(ImageBasedLight, SwitchedOnWhileTheWindowChanges)
{
  EnvironmentStage stage;
  stage.SetEnvironment(EvenTexture<float>(Radiance));
  stage.AddBalls({ { 0.0, 0.5 }, { 1.0, 0.1 } });
  stage.Renderer()->UseImageBasedLightingOff();
  for (const char* preset : { "balanced", "high" })
  {
    stage.Measure(preset, 2);
    stage.Renderer()->UseImageBasedLightingOn();
    for (const int side : { 64, 96, 32 })
    {
      stage.Scene.Window->SetSize(2 * side, side);
      stage.Scene.Window->Render();
      EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << preset << ", " << side;
    }
    stage.Renderer()->UseImageBasedLightingOff();
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
  const bool many = ScattersManyTimes(stock[2].Mean);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    std::printf("metallic %.0f, roughness %.2f: stock %.1f, high %.1f +- %.1f\n", balls[i].Metallic,
      balls[i].Roughness, stock[i].Mean, high[i].Mean, high[i].Deviation);
    const bool rough = balls[i].Roughness == 1.0;
    EXPECT_NEAR(high[i].Mean, rough && many ? 100.0 : stock[i].Mean, 3.0); // 100 by earlier VTKs
    EXPECT_LE(high[i].Deviation, 4.0);
  }
}

// A picture of eight bits is decoded, or not, as VTK's image-based light does it: apart for what matter reflects and for
// what highlights do.
TEST(ImageBasedLight, ColorSpacesOfEnvironments)
{
  struct Case
  {
    const char* Name;
    vtkSmartPointer<vtkTexture> (*Make)(double value, bool srgb);
    bool TextureSrgb;
    bool RendererSrgb;
  };
  const std::array<Case, 9> cases = { {
    { "8 bits", EvenTexture<unsigned char>, false, false },
    { "8 bits, texture is sRGB", EvenTexture<unsigned char>, true, false },
    { "8 bits, renderer is told so", EvenTexture<unsigned char>, false, true },
    { "8 bits, both", EvenTexture<unsigned char>, true, true },
    { "16 bits", EvenTexture<unsigned short>, false, false },
    { "16 bits, texture is sRGB", EvenTexture<unsigned short>, true, false },
    { "16 bits, renderer is told so", EvenTexture<unsigned short>, false, true },
    { "float", EvenTexture<float>, false, false },
    { "float, renderer is told so", EvenTexture<float>, false, true },
  } };
  EnvironmentStage stage;
  stage.AddBalls({ { 0.0, 1.0 }, { 1.0, 0.0 } });
  for (const bool harmonics : { true, false })
  {
    stage.Renderer()->SetUseSphericalHarmonics(harmonics);
    for (const Case& row : cases)
    {
      if (!harmonics && row.Make != cases[0].Make)
      {
        continue;
      }
      stage.SetEnvironment(row.Make(Radiance, row.TextureSrgb), row.RendererSrgb);
      const auto stock = stage.Measure("stock", 1);
      const auto high = stage.Measure("high", 2);
      const auto reference = stage.Measure("reference", 16);
      std::printf("%-30s matte: stock %.1f, high %.1f, reference %.1f; mirror: %.1f, %.1f, %.1f\n",
        row.Name, stock[0].Mean, high[0].Mean, reference[0].Mean, stock[1].Mean, high[1].Mean,
        reference[1].Mean);
      for (std::size_t i = 0; i < stock.size(); ++i)
      {
        EXPECT_GT(stock[i].Mean, 40.0) << row.Name;
        EXPECT_NEAR(high[i].Mean, stock[i].Mean, 3.0) << row.Name;
        EXPECT_NEAR(reference[i].Mean, stock[i].Mean, 3.0) << row.Name;
      }
    }
  }
}

// A skybox is in linear pictures by its radiance, and displayed as VTK displays it.
TEST(ImageBasedLight, VisibleSkiesHaveTheirRadiance)
{
  struct Case
  {
    const char* Name;
    vtkSmartPointer<vtkTexture> Texture;
    bool GammaCorrect;
    double Expected;
  };
  const std::array<Case, 4> cases = { {
    { "float, corrected", EvenTexture<float>(2.5), true, 2.5 },
    { "float, as it is", EvenTexture<float>(0.25), false, 0.25 },
    { "8 bits, as they are", EvenTexture<unsigned char>(0.5), false, std::pow(128.0 / 255.0, 2.2) },
    { "8 bits, sRGB, corrected", EvenTexture<unsigned char>(0.5, true), true, 0.2159 },
  } };
  EnvironmentStage stage;
  stage.AddBalls({ { 1.0, 0.0 } });
  vtkNew<vtkSkybox> sky;
  sky->SetProjectionToSphere();
  stage.Renderer()->AddActor(sky);
  for (const Case& row : cases)
  {
    stage.SetEnvironment(row.Texture);
    sky->SetTexture(row.Texture);
    sky->SetGammaCorrect(row.GammaCorrect);
    stage.Measure("stock", 1);
    const double stock = stage.Last.Grey(0, 0);
    for (const char* preset : { "off", "balanced", "reference" })
    {
      stage.Measure(preset, 2);
      EXPECT_NEAR(stage.Last.Grey(0, 0), stock, 1.0) << row.Name << ' ' << preset;
      vtkNew<vtkImageData> radiance;
      ASSERT_TRUE(stage.Pass->GetRadiance(stage.Renderer(), radiance));
      const auto* corner = static_cast<const float*>(radiance->GetScalarPointer());
      std::printf("%-24s %-9s %.4f of %.4f\n", row.Name, preset, corner[1], row.Expected);
      for (int channel = 0; channel < 3; ++channel)
      {
        // OpenGL decodes by a table.
        EXPECT_NEAR(corner[channel], row.Expected, 0.01 * row.Expected)
          << row.Name << ' ' << preset;
      }
      EXPECT_EQ(corner[3], 1.0f) << row.Name << ' ' << preset;
    }
  }
}

// A small sun gives most of the light: few of a probe's rays point to it, yet it counts by its size.
TEST(ImageBasedLight, SunsReachProbes)
{
  vtkSmartPointer<vtkTexture> texture = EvenTexture<float>(0.1);
  auto* values = static_cast<float*>(texture->GetInput()->GetScalarPointer(23, 9, 0));
  std::fill_n(values, 3, 40.0f); // of 512 pixels, one
  EnvironmentStage stage;
  stage.SetEnvironment(texture);
  stage.AddBalls({ { 0.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 1.0 } });
  const auto high = stage.Measure("high", 16);
  const auto reference = stage.Measure("reference", 64);
  for (std::size_t i = 0; i < high.size(); ++i)
  {
    std::printf("high %.1f +- %.1f, reference %.1f +- %.1f\n", high[i].Mean, high[i].Deviation,
      reference[i].Mean, reference[i].Deviation);
    EXPECT_GT(reference[i].Mean, 100.0);
    EXPECT_NEAR(high[i].Mean, high[0].Mean, 2.0) << "what probes see depends on where they are";
    // Probes smooth what they receive.
    EXPECT_NEAR(high[i].Mean, reference[i].Mean, 6.0);
  }
}

// Cells of equal solid angles keep the mean of the sphere, whatever the sizes.
TEST(ImageBasedLight, CellsKeepTheMean)
{
  constexpr int width = 48;
  constexpr int height = 20;
  std::vector<glm::vec4> pixels;
  double expected = 0.0;
  for (int i = 0; i < width * height; ++i)
  {
    const double low = (static_cast<double>(i / width) / height - 0.5) * vtkMath::Pi();
    const double high = low + vtkMath::Pi() / height;
    pixels.emplace_back(static_cast<float>(i * 7 % 13));
    expected += pixels.back().x * (std::sin(high) - std::sin(low)) / (2.0 * width);
  }
  using penumbra::EqualCells;
  for (const int rows : { 4, 64 })
  {
    const EqualCells fine = EqualCells::Of(pixels, width, height, 2 * rows, rows);
    for (const EqualCells& cells : { fine, fine.Coarser(4, 2) })
    {
      double mean = 0.0;
      for (const glm::vec4& value : cells.Values)
      {
        mean += value.x / static_cast<double>(cells.Values.size());
      }
      EXPECT_NEAR(mean, expected, 0.01 * expected) << rows;
    }
  }
}
