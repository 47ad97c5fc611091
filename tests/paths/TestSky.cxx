// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces under an environment receive what its picture sums up to.
#include "Agreement.h"

#include "rays/RaySky.h"

#include "vtkGIPathTracing.h"
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
constexpr int Side = 64;    // of the picture that is measured
constexpr int Samples = 32; // in each of its pixels
constexpr double Pi = 3.14159265358979323846;

// A sky with a small sun, and a ground that is darker.
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
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn(); // VTK insists
  return texture;
}

// The value of the picture between its pixels.
std::array<double, 3> Between(double u, double v)
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

// What a white diffuse surface of that normal reflects.
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
        const auto value = Between(u, v);
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += share * value[c];
        }
      }
    }
  }
  return sum;
}

// The mean of a white plane that fills the picture, in linear values.
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
  // Small: VTK's filtering for its own shaders takes longer than the rays otherwise.
  auto* renderer = static_cast<vtkOpenGLRenderer*>(stage.Renderer.Get());
  renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(2);
  renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
  renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
  renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.3f);
  renderer->GetEnvMapLookupTable()->SetLUTSize(8);
  renderer->GetEnvMapLookupTable()->SetLUTSamples(8);
  // A light that is too faint to count keeps VTK from drawing flat colours.
  stage.Renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> faint;
  faint->SetIntensity(1e-9);
  stage.Renderer->AddLight(faint);
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

// Three in a thousand for what follows the picture; directions that follow the surface find the
// small sun seldom, which leaves three percent of noise.
TEST(Sky, LightsByTheSumOfItsPicture)
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

// Cumulative chances grow to one, and follow the light.
TEST(Sky, TableOfChances)
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
      EXPECT_GT(table[9 * row + i + 1], table[9 * row + i]) << "a direction without any chance";
    }
  }
  // Nine tenths, as filtering spreads the pixel over its neighbours, and the share of the tenth
  // that is even.
  const double rows[3] = { std::cos(0.375 * Pi), 2.0 * std::cos(0.125 * Pi), std::cos(0.125 * Pi) };
  const double sum = rows[0] + rows[1] + rows[2];
  const double band = 0.5 * (std::sin(0.0) - std::sin(-0.25 * Pi));
  const double inBand = table[9 * 4 + 2] - table[9 * 4 + 1];
  EXPECT_NEAR(inBand, 0.9 * rows[1] / sum + 0.1 * band, 1e-5);
  EXPECT_NEAR(
    (table[9 + 4] - table[9 + 3]) * inBand, 0.45 * rows[1] / sum + 0.1 * band / 8.0, 1e-5);
}

// A picture that changes its pixels tells nobody: the mean starts anew all the same, with them.
TEST(Sky, ChangedPicturesShow)
{
  Stage stage;
  stage.Window->SetSize(Side, Side);
  vtkNew<vtkPlaneSource> plane;
  vtkActor* actor = stage.Add(plane);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(200.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
  auto pass = stage.SetPasses().front();
  auto* paths = vtkGIPathTracing::SafeDownCast(pass->GetTechnique("path-tracing"));
  paths->EnabledOn();
  Shoot(stage.Window);
  EXPECT_EQ(Shoot(stage.Window).At(Side / 2, Side / 2)[1], 200);
  EXPECT_EQ(paths->GetSamplesTaken(stage.Renderer), 2);
  image->GetPointData()->GetScalars()->Fill(90.0);
  image->Modified();
  EXPECT_EQ(Shoot(stage.Window).At(Side / 2, Side / 2)[1], 90);
  EXPECT_EQ(paths->GetSamplesTaken(stage.Renderer), 1);
}
