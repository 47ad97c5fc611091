// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Denoised pictures of the path tracer where light, or the picture, is not as usual.
 */
#include "DenoisedStage.h"

#include "gpu/GL.h"

#include <vtkSkybox.h>

#include <cmath>
#include <cstdio>
#include <limits>

using namespace penumbra_test;

namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Pixels that the filter reaches after 16 paths: its steps are 1, 2, 4 and 8 pixels.
constexpr int Reach = 15;

class DenoisedPathsHostile : public DenoisedStage
{
protected:
  void TearDown() override
  {
    EXPECT_STREQ(this->Pass->GetLastError(), "");
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }

  vtkSmartPointer<vtkImageData> KeepProgress()
  {
    auto kept = vtkSmartPointer<vtkImageData>::New();
    EXPECT_TRUE(this->Paths->GetProgress(this->Pass, this->Scene.Renderer, kept));
    return kept;
  }

  /// The picture of the next frame after saved progress.
  Values Resume(vtkImageData* kept, const std::string& method)
  {
    this->Denoise(method);
    this->Pass->Restart();
    EXPECT_TRUE(this->Paths->SetProgress(this->Scene.Renderer, kept));
    return this->After(1);
  }

  /// Progress in which one more path through a pixel found this radiance.
  static vtkSmartPointer<vtkImageData> WithBrightPath(
    vtkImageData* kept, vtkIdType pixel, double radiance)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(kept);
    const auto add = [&](const char* name, int channel, double value) {
      vtkDataArray* sum = image->GetPointData()->GetArray(name);
      sum->SetComponent(pixel, channel, sum->GetComponent(pixel, channel) + value);
    };
    for (int channel = 0; channel < 3; ++channel)
    {
      add("path-tracing.shown", channel, radiance);
    }
    add("path-tracing.encoded", 3, radiance * radiance);
    return image;
  }

  /// Two yards with a wall between them, each lit by a lamp. A panel shines in the left one, too.
  void AddYards()
  {
    this->AddBox(-2.0, 2.0, -1.0, 1.0, -0.1, 0.0, 0.7);
    this->AddBox(-0.05, 0.05, -1.0, 1.0, 0.0, 1.5, 0.7);
    this->AddBox(0.5, 0.9, -0.2, 0.2, 0.0, 0.5, 0.7);
    this->AddBox(-0.9, -0.5, -0.2, 0.2, 0.0, 0.5, 0.7);
    this->Panel = Paint(AddFloor(this->Scene, -1.5, -0.9, -0.3, 0.3, 1.0), 0.0)->GetProperty();
    this->Panel->SetAmbient(1.0);
    this->LookFrom(0.0, -2.5, 2.0, 0.0, 0.0, 0.0);
    this->Lamp->SetPosition(1.4, 0.2, 1.0);
    this->Lamp->SetIntensity(1.0);
    this->LeftLamp->SetLightTypeToSceneLight();
    ShineAllRound(this->LeftLamp);
    this->LeftLamp->SetPosition(-0.5, 0.5, 1.2);
    this->LeftLamp->SetIntensity(0.5);
    this->Scene.Renderer->AddLight(this->LeftLamp);
  }

  /// What a picture of the yards has of another one. good: that with usual light; plain: without denoising.
  static void ExpectOnlyTheLeftYard(
    const Values& picture, const Values& good, const Values& plain, double tolerance)
  {
    double worst = 0.0;
    int unlike = 0;
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      unlike += std::isfinite(picture[i]) != std::isfinite(plain[i]);
      const bool right = i % Width > Width / 2 + Reach;
      worst = std::max(worst, right ? std::abs(picture[i] - good[i]) : 0.0);
    }
    std::printf("largest difference behind the wall %.5f\n", worst);
    EXPECT_EQ(unlike, 0) << "pixels are finite only without, or only with denoising";
    EXPECT_LE(worst, tolerance);
  }

  /// Whether a pixel and its neighbours show the same. Pixels at edges show two surfaces, as the eye's rays happen to meet them.
  template <typename Condition>
  static bool ShowsAround(const Values& picture, std::size_t pixel, Condition shows)
  {
    const int x = static_cast<int>(pixel) % Width;
    const int y = static_cast<int>(pixel) / Width;
    bool all = true;
    for (int i = std::max(y - 1, 0); i <= std::min(y + 1, Height - 1); ++i)
    {
      for (int j = std::max(x - 1, 0); j <= std::min(x + 1, Width - 1); ++j)
      {
        all = all && shows(picture[static_cast<std::size_t>(i * Width + j)]);
      }
    }
    return all;
  }

  vtkProperty* Panel = nullptr;
  vtkNew<vtkLight> LeftLamp;
};
}

// A path that finds 10,000 times the mean light becomes a spot. It stays small, and keeps the light.
TEST_F(DenoisedPathsHostile, OneBrightPathBecomesASpot)
{
  this->AddRoomWithPanel();
  this->Paths->SetSamples(Few);
  const double bright = 1e4 * Mean(this->Draw("", Few - 1));
  const auto kept = this->KeepProgress();
  for (const int pixel : { 22 * Width + 30, 10 * Width + 15 })
  {
    const auto hit = WithBrightPath(kept, pixel, bright);
    const Values plain = this->Resume(hit, "");
    for (const std::string method : { "filter", "neural" })
    {
      const Values usual = this->Resume(kept, method);
      const Values spot = this->Resume(hit, method);
      int wide = 0;
      int high = 0;
      int far = 0;
      for (int i = 0; i < Width * Height; ++i)
      {
        EXPECT_TRUE(std::isfinite(spot[i]));
        wide += spot[i] > 2.0 * usual[i];
        high += spot[i] > 10.0 * usual[i];
        const bool reached = std::abs(i % Width - pixel % Width) <= Reach &&
          std::abs(i / Width - pixel / Width) <= Reach;
        far += reached ? 0 : spot[i] > 1.1 * usual[i];
      }
      std::printf("%s: %d pixels brighter by 2, %d by 10, %d far away; pixel %.2f of %.2f; "
                  "mean %.5f of %.5f\n",
        method.c_str(), wide, high, far, spot[pixel], plain[pixel], Mean(spot), Mean(plain));
      EXPECT_LT(wide, method == "filter" ? 180 : 70);
      EXPECT_LT(high, method == "filter" ? 40 : 24);
      EXPECT_EQ(far, 0);
      EXPECT_LT(spot[pixel], 0.3 * plain[pixel]);
      EXPECT_NEAR(Mean(spot), Mean(plain), 0.03 * Mean(plain));
    }
  }
}

TEST_F(DenoisedPathsHostile, BrokenLightStaysWhereItIs)
{
  this->AddYards();
  const auto shine = [this](bool lamp, double value) {
    lamp ? this->LeftLamp->SetDiffuseColor(value, value, value)
         : this->Panel->SetAmbientColor(value, value, value);
  };
  for (const char* method : { "filter", "neural" })
  {
    const Values good = this->Draw(method, Few);
    for (const bool lamp : { false, true })
    {
      for (const double value : { 1e30, 1e38, Infinite, -Infinite, NotANumber })
      {
        shine(lamp, value);
        const Values plain = this->Draw("", Few);
        const Values picture = this->Draw(method, Few);
        std::printf("%s, a %s of %g: ", method, lamp ? "lamp" : "panel", value);
        // The network sees what is around a pixel; so does the regression on normals, in tiles.
        const bool guided = std::string(method) == "neural";
        ExpectOnlyTheLeftYard(picture, good, plain, guided ? 0.003 : 2e-4);
        if (value != 1e38) // whose sums overflow
        {
          EXPECT_NEAR(Mean(picture), Mean(plain), 0.05 * Mean(plain));
        }
        shine(lamp, 1.0);
      }
    }
  }
}

// Three tiles of the regression on normals beyond the filter, no digit changes. Nearer, slopes of broken light leave some noise.
TEST_F(DenoisedPathsHostile, BrokenLightReachesNoFartherThanTheTiles)
{
  constexpr int width = 160;
  this->Scene.Window->SetSize(width, 120);
  this->AddYards();
  const Values good = this->Draw("filter", Few);
  this->Panel->SetAmbientColor(1e30, 1e30, 1e30);
  const Values picture = this->Draw("filter", Few);
  double near = 0.0;
  double far = 0.0;
  double seen = 0.0;
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    const int beyond = static_cast<int>(i) % width - width / 2 - Reach;
    const double difference = std::abs(picture[i] - good[i]);
    near = std::max(near, beyond > 0 ? difference : 0.0);
    far = std::max(far, beyond > 3 * 16 ? difference : 0.0);
    seen = std::max(seen, beyond > 3 * 16 ? good[i] : 0.0);
  }
  std::printf("largest difference behind the wall %.6f, beyond the tiles %.6f\n", near, far);
  EXPECT_GT(seen, 0.01);
  EXPECT_LT(near, 0.01);
  EXPECT_EQ(far, 0.0);
}

TEST_F(DenoisedPathsHostile, SkyAndUnlitColoursStay)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 4, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (vtkIdType i = 0; i < image->GetPointData()->GetScalars()->GetNumberOfValues(); ++i)
  {
    static_cast<float*>(image->GetScalarPointer())[i] = static_cast<float>(i % 7);
  }
  const auto texture = EnvironmentTexture(image);
  ShineFrom(this->Scene.Renderer, texture);
  vtkNew<vtkSkybox> sky;
  sky->SetProjectionToSphere();
  sky->SetTexture(texture);
  this->Scene.Renderer->AddActor(sky);
  this->LookFrom(0.0, 0.0, 0.0, 1.0, 0.0, 0.0);
  const Values seen = this->Draw("", 4);
  EXPECT_GT(Mean(seen), 1.0);
  EXPECT_EQ(this->Draw("filter", 4), seen);
  EXPECT_EQ(this->Draw("neural", 4), seen);

  vtkProperty* colour = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7)->GetProperty();
  colour->LightingOff();
  colour->SetColor(0.2, 0.3, 0.7);
  for (const char* method : { "", "filter", "neural" })
  {
    EXPECT_LT(LargestError(this->Draw(method, 4), 0.7 * 0.4), 0.01) << method;
  }
}

// Walls that shine with 0.5 and reflect nothing, and a block in their light.
TEST_F(DenoisedPathsHostile, EvenLightStays)
{
  this->ShowBlockInUniformLight();
  this->LookFrom(0.9, 0.8, 0.3, -0.5, -0.5, -0.6);
  const Values plain = this->Draw("", Few);
  for (const char* method : { "filter", "neural" })
  {
    const Values picture = this->Draw(method, Few);
    double wall = 0.0;
    double block = 0.0;
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      const bool isWall = ShowsAround(plain, i, [](double v) { return std::abs(v - 0.5) < 1e-4; });
      const bool isBlock = ShowsAround(plain, i, [](double v) { return v < 0.32; });
      wall = std::max(wall, isWall ? std::abs(picture[i] - 0.5) : 0.0);
      block = std::max(block, isBlock ? std::abs(picture[i] - 0.3) : 0.0);
    }
    std::printf("%s: walls within %.5f of 0.5, block within %.4f of 0.3; mean %.5f of %.5f\n",
      method, wall, block, Mean(picture), Mean(plain));
    EXPECT_LT(wall, 1e-4);
    EXPECT_LT(block, 0.012);
    EXPECT_NEAR(Mean(picture), Mean(plain), 1e-3 * Mean(plain));
  }
}

TEST_F(DenoisedPathsHostile, TinyPicturesAreDrawn)
{
  this->AddRoomWithPanel();
  for (const auto& size : { std::array<int, 2>{ 1, 1 }, { 3, 5 } })
  {
    this->Scene.Window->SetSize(size[0], size[1]);
    for (const int paths : { 1, Few })
    {
      const Values plain = this->Draw("", paths);
      for (const char* method : { "filter", "neural" })
      {
        const Values picture = this->Draw(method, paths);
        ASSERT_EQ(picture.size(), static_cast<std::size_t>(size[0] * size[1]));
        std::printf("%d x %d, %d paths, %s: mean %.5f of %.5f\n", size[0], size[1], paths, method,
          Mean(picture), Mean(plain));
        for (const double value : picture)
        {
          EXPECT_TRUE(std::isfinite(value) && value >= 0.0);
        }
        EXPECT_NEAR(Mean(picture), Mean(plain), 0.1 * Mean(plain));
      }
    }
  }
}

// Saved progress does not say what lamps show without light. It is found again, even if no paths are left to be traced.
TEST_F(DenoisedPathsHostile, LampsStayWhenAPictureIsResumed)
{
  this->AddRoomWithPanel();
  this->LookFrom(0.8, 0.8, -0.8, 0.0, 0.0, 1.0);
  this->Paths->SetSamples(Few);
  const Values expected = this->Draw("filter", Few);
  for (const int paths : { Few - 1, Few })
  {
    this->Draw("", paths);
    const Values resumed = this->Resume(this->KeepProgress(), "filter");
    EXPECT_EQ(this->Paths->GetSamplesTaken(this->Scene.Renderer), Few);
    double worst = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      worst = std::max(worst, std::abs(resumed[i] - expected[i]));
    }
    std::printf("resumed after %d paths: largest difference %.5f\n", paths, worst);
    EXPECT_LT(worst, 2e-3);
  }
}
