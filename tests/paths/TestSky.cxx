// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces under an environment receive the integral of its image.
#include "Agreement.h"
#include "SceneParts.h"

#include "rays/RaySky.h"

#include "vtkGITechnique.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPlaneSource.h"

#include <cmath>

using namespace penumbra_test;

namespace
{
constexpr int Width = 64;
constexpr int Height = 32;
constexpr int Side = 64;    // width of the measured picture
constexpr int Samples = 32; // per pixel
constexpr double Pi = 3.14159265358979323846;

// A sky with a small sun and a darker ground.
std::array<double, 3> Radiance(int x, int y)
{
  const bool sun = x >= 40 && x < 43 && y >= 22 && y < 25;
  const double ground = y < Height / 2 ? 0.3 : 1.0;
  return { sun ? 30.0 : 0.5 * ground, sun ? 20.0 : 0.4 * ground,
    (sun ? 10.0 : 0.2 + 0.01 * x) * ground };
}

vtkSmartPointer<vtkTexture> SkyTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Width, Height, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const auto value = Radiance(x, y);
      std::copy(value.begin(), value.end(), static_cast<float*>(image->GetScalarPointer(x, y, 0)));
    }
  }
  return EnvironmentTexture(image);
}

// Radiance interpolated between pixels.
std::array<double, 3> Interpolated(double u, double v)
{
  const double x = u * Width - 0.5;
  const double y = std::clamp(v * Height - 0.5, 0.0, Height - 1.0);
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = std::min(static_cast<int>(y), Height - 2);
  std::array<double, 3> sum{};
  for (int i = 0; i < 4; ++i)
  {
    const double wx = i & 1 ? x - x0 : 1.0 - (x - x0);
    const double wy = i & 2 ? y - y0 : 1.0 - (y - y0);
    const auto value = Radiance((x0 + (i & 1) + Width) % Width, y0 + (i >> 1));
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += wx * wy * value[c];
    }
  }
  return sum;
}

using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Light that a white diffuse surface with this normal reflects.
Vector Expected(const Vector& normal, const Vector& right, const Vector& up)
{
  const Vector front = { right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2],
    right[0] * up[1] - right[1] * up[0] };
  constexpr int steps = 1024;
  Vector sum{};
  for (int j = 0; j < steps; ++j)
  {
    const double v = (j + 0.5) / steps;
    const double latitude = (v - 0.5) * Pi;
    for (int i = 0; i < 2 * steps; ++i)
    {
      const double u = (i + 0.5) / (2 * steps);
      const double longitude = (u - 0.5) * 2.0 * Pi;
      const Vector sky = { std::cos(latitude) * std::cos(longitude), std::sin(latitude),
        std::cos(latitude) * std::sin(longitude) };
      Vector world{};
      for (int c = 0; c < 3; ++c)
      {
        world[c] = right[c] * sky[0] + up[c] * sky[1] + front[c] * sky[2];
      }
      const double facing = Dot(world, normal);
      if (facing > 0.0)
      {
        const double share = facing * std::cos(latitude) * (Pi / steps) * (Pi / steps) / Pi;
        const auto value = Interpolated(u, v);
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += share * value[c];
        }
      }
    }
  }
  return sum;
}

// Mean radiance of a white plane that fills the picture.
Vector Measured(const char* strategy, const Vector& normal, const Vector& right, const Vector& up)
{
  Stage stage;
  stage.Window->SetSize(Side, Side);
  vtkNew<vtkPlaneSource> plane;
  plane->SetNormal(normal[0], normal[1], normal[2]);
  vtkActor* actor = stage.Add(plane);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.3);
  camera->SetPosition(3.0 * normal[0], 3.0 * normal[1], 3.0 * normal[2]);
  camera->SetViewUp(normal[1], normal[2], normal[0]);
  stage.Renderer->ResetCameraClippingRange();
  stage.Renderer->SetEnvironmentTexture(SkyTexture());
  stage.Renderer->SetEnvironmentRight(right[0], right[1], right[2]);
  stage.Renderer->SetEnvironmentUp(up[0], up[1], up[2]);
  stage.Renderer->UseImageBasedLightingOn();
  // Small tables: VTK's filtering for its own shaders would take longer than the rays.
  auto* renderer = static_cast<vtkOpenGLRenderer*>(stage.Renderer.Get());
  renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(2);
  renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
  renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
  renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.3f);
  renderer->GetEnvMapLookupTable()->SetLUTSize(8);
  renderer->GetEnvMapLookupTable()->SetLUTSamples(8);
  AddFaintLight(stage.Renderer);
  auto pass = stage.SetPasses().front();
  pass->KeepRadianceOn();
  vtkGITechnique* paths = pass->GetTechnique("path-tracing");
  paths->EnabledOn();
  paths->SetParameter("bounces", 0);
  paths->SetParameter("samples", Samples);
  paths->SetParameterFromText("strategy", strategy);
  for (int i = 0; i < Samples; ++i)
  {
    stage.Window->Render();
  }
  vtkNew<vtkImageData> image;
  EXPECT_TRUE(pass->GetRadiance(stage.Renderer, image));
  Vector mean{};
  for (int i = 0; i < Side * Side; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      mean[c] += image->GetPointData()->GetScalars()->GetComponent(i, c) / (Side * Side);
    }
  }
  return mean;
}

struct Case
{
  const char* Name;
  Vector Normal, Right, Up;
};

const std::array<Case, 4> Cases = { {
  { "up", { 0.0, 1.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } },
  { "toward the sun", { -0.6, 0.48, 0.64 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } },
  { "sky turned upright", { 0.6, 0.0, 0.8 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } },
  { "sky turned askew", { 0.0, 0.6, 0.8 }, { 0.0, 0.8, -0.6 }, { 0.8, 0.36, 0.48 } },
} };
}

// Directions sampled from the image err by at most three in a thousand. Directions sampled from the surface rarely hit
// the small sun, which leaves three percent of noise.
TEST(Sky, LightsSurfacesByItsIntegral)
{
  for (const Case& row : Cases)
  {
    const Vector expected = Expected(row.Normal, row.Right, row.Up);
    for (const auto& [strategy, tolerance] :
      { std::pair("both", 0.003), std::pair("lights", 0.003), std::pair("surfaces", 0.03) })
    {
      const Vector found = Measured(strategy, row.Normal, row.Right, row.Up);
      std::printf("%-20s %-9s %.4f %.4f %.4f, expected %.4f %.4f %.4f\n", row.Name, strategy,
        found[0], found[1], found[2], expected[0], expected[1], expected[2]);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(found[c], expected[c], tolerance * expected[c]) << row.Name << ' ' << strategy;
      }
    }
  }
}

// Cumulative probabilities rise to one and follow the light.
TEST(Sky, TableHoldsCumulativeProbabilities)
{
  std::vector<glm::vec4> pixels(32, glm::vec4(0.0f));
  pixels[8 + 3] = glm::vec4(1.0f); // the second row's fourth
  const std::vector<float> table = penumbra::MakeSkyTable(pixels, 8, 4, 8, 4);
  ASSERT_EQ(table.size(), 9u * 5u);
  for (int row = 0; row <= 4; ++row)
  {
    const int cells = row == 4 ? 4 : 8;
    EXPECT_EQ(table[9 * row], 0.0f);
    EXPECT_EQ(table[9 * row + cells], 1.0f);
    for (int i = 0; i < cells; ++i)
    {
      EXPECT_GT(table[9 * row + i + 1], table[9 * row + i]) << "a direction without probability";
    }
  }
  // Nine tenths follow the pixel, which filtering spreads over its neighbours; one tenth is uniform.
  const double rows[3] = { std::cos(0.375 * Pi), 2.0 * std::cos(0.125 * Pi), std::cos(0.125 * Pi) };
  const double sum = rows[0] + rows[1] + rows[2];
  const double band = 0.5 * (std::sin(0.0) - std::sin(-0.25 * Pi));
  const double inBand = table[9 * 4 + 2] - table[9 * 4 + 1];
  EXPECT_NEAR(inBand, 0.9 * rows[1] / sum + 0.1 * band, 1e-5);
  EXPECT_NEAR(
    (table[9 + 4] - table[9 + 3]) * inBand, 0.45 * rows[1] / sum + 0.1 * band / 8.0, 1e-5);
}
