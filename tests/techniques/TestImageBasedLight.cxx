// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Image-based light is the same from VTK, from probes and from the path tracer.
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
constexpr double Radiance = 0.5;           // of the furnace
constexpr double SingleScattering = 100.0; // the colour of a metal ball of roughness 1 in it

// VTK 9.6.1 and later add multiple scattering between microfacets, but only to image-based light
// (docs/indirect-light.md). There a rough metal loses no light, with the passes too; under lamps, probes and paths it still
// does. Other materials hardly change.
bool HasMultipleScattering(double stockRoughMetal)
{
  const bool multiple = stockRoughMetal > 120.0;
  EXPECT_TRUE(!multiple || VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 1)) << stockRoughMetal;
  return multiple;
}
}

// In uniform surroundings each ball has one colour, the same with every preset.
TEST(ImageBasedLight, IsTheSameWithEveryPresetInAFurnace)
{
  EnvironmentStage stage;
  stage.SetEnvironment(ConstantTexture<float>(Radiance));
  const auto balls =
    stage.AddBalls({ { 0.0, 0.5 }, { 0.0, 0.1 }, { 1.0, 0.0 }, { 1.0, 0.35 }, { 1.0, 1.0 } });
  const auto stock = stage.Measure("stock", 1);
  // Few frames, so that probes are still updated before the capture.
  const auto high = stage.Measure("high", 3);
  const auto reference = stage.Measure("reference", 64);
  const bool multiple = HasMultipleScattering(stock[4].Mean);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    std::printf("metallic %.0f, roughness %.2f: stock %.1f +- %.1f, high %.1f +- %.1f, "
                "reference %.1f +- %.1f\n",
      balls[i].Metallic, balls[i].Roughness, stock[i].Mean, stock[i].Deviation, high[i].Mean,
      high[i].Deviation, reference[i].Mean, reference[i].Deviation);
    EXPECT_GT(stock[i].Mean, 80.0);
    const bool scatters = multiple && balls[i].Metallic == 1.0 && balls[i].Roughness == 1.0;
    const double tolerance = multiple ? 6.0 : 3.0;
    EXPECT_NEAR(high[i].Mean, stock[i].Mean, tolerance);
    EXPECT_NEAR(reference[i].Mean, scatters ? SingleScattering : stock[i].Mean, tolerance);
    EXPECT_NEAR(high[i].Mean, scatters ? stock[i].Mean : reference[i].Mean, 3.0);
    EXPECT_LE(high[i].Deviation, 4.0);
    EXPECT_LE(reference[i].Deviation, 4.0);
  }
}

// Textures of a frame that stay bound must not be taken for VTK's own: a resize of the window deletes them.
TEST(ImageBasedLight, SwitchedOnBeforeAResizeRaisesNoGLError)
{
  EnvironmentStage stage;
  stage.SetEnvironment(ConstantTexture<float>(Radiance));
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

// VTK draws translucent surfaces after the passes, with its own textures of image-based light.
TEST(ImageBasedLight, IsTheSameOnTranslucentBallsInAFurnace)
{
  EnvironmentStage stage;
  stage.SetEnvironment(ConstantTexture<float>(Radiance));
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

// Images of eight bits are decoded, or not, as VTK does it: separately for diffuse reflection and for highlights.
TEST(ImageBasedLight, DecodesColorSpacesLikeVTK)
{
  struct Case
  {
    const char* Name;
    vtkSmartPointer<vtkTexture> (*Make)(double value, bool srgb);
    bool TextureSrgb;
    bool RendererSrgb;
  };
  const std::array<Case, 9> cases = { {
    { "8 bits", ConstantTexture<unsigned char>, false, false },
    { "8 bits, texture is sRGB", ConstantTexture<unsigned char>, true, false },
    { "8 bits, renderer says sRGB", ConstantTexture<unsigned char>, false, true },
    { "8 bits, both", ConstantTexture<unsigned char>, true, true },
    { "16 bits", ConstantTexture<unsigned short>, false, false },
    { "16 bits, texture is sRGB", ConstantTexture<unsigned short>, true, false },
    { "16 bits, renderer says sRGB", ConstantTexture<unsigned short>, false, true },
    { "float", ConstantTexture<float>, false, false },
    { "float, renderer says sRGB", ConstantTexture<float>, false, true },
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

// A skybox has its radiance in linear pictures and VTK's colours on display.
TEST(ImageBasedLight, KeepsTheRadianceOfVisibleSkies)
{
  struct Case
  {
    const char* Name;
    vtkSmartPointer<vtkTexture> Texture;
    bool GammaCorrect;
    double Expected;
  };
  const std::array<Case, 4> cases = { {
    { "float, corrected", ConstantTexture<float>(2.5), true, 2.5 },
    { "float, uncorrected", ConstantTexture<float>(0.25), false, 0.25 },
    { "8 bits, uncorrected", ConstantTexture<unsigned char>(0.5), false,
      std::pow(128.0 / 255.0, 2.2) },
    { "8 bits, sRGB, corrected", ConstantTexture<unsigned char>(0.5, true), true, 0.2159 },
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
        // OpenGL decodes with a table.
        EXPECT_NEAR(corner[channel], row.Expected, 0.01 * row.Expected)
          << row.Name << ' ' << preset;
      }
      EXPECT_EQ(corner[3], 1.0f) << row.Name << ' ' << preset;
    }
  }
}

// A small sun gives most of the light. Few rays of a probe hit it, yet it counts with its solid angle.
TEST(ImageBasedLight, LightsProbesWithASmallSun)
{
  vtkSmartPointer<vtkTexture> texture = ConstantTexture<float>(0.1);
  auto* values = static_cast<float*>(texture->GetInput()->GetScalarPointer(23, 9, 0));
  std::fill_n(values, 3, 40.0f); // one of 512 pixels
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
    EXPECT_NEAR(high[i].Mean, high[0].Mean, 2.0) << "the light depends on the position";
    // Probes smooth the light that they receive.
    EXPECT_NEAR(high[i].Mean, reference[i].Mean, 6.0);
  }
}

// Cells of equal solid angle preserve the mean over the sphere, whatever their size.
TEST(ImageBasedLight, CellsPreserveTheMean)
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
