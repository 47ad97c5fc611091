// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Skies: closed-form values of their images, the sun's place, and limits of their numbers.
#include "Messages.h"

#include "sky/SunPosition.h"

#include "vtkGILightShape.h"
#include "vtkGISkySource.h"
#include "vtkGISoftBox.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

using namespace penumbra_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;
using Color = std::array<double, 3>;

Color Radiance(vtkGISkySource* sky, double elevation, double azimuth)
{
  Color color;
  sky->GetRadiance(elevation, azimuth, color.data());
  return color;
}

Color Irradiance(vtkGISkySource* sky, double elevation, double azimuth)
{
  Color color;
  sky->GetIrradiance(elevation, azimuth, color.data());
  return color;
}

double Luminance(const Color& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

// Integral of the image over all directions.
double Power(vtkGISkySource* sky)
{
  vtkImageData* image = sky->GetImage();
  const int width = image->GetDimensions()[0];
  const int height = image->GetDimensions()[1];
  double sum = 0.0;
  for (int y = 0; y < height; ++y)
  {
    const double band =
      std::sin(((y + 1.0) / height - 0.5) * Pi) - std::sin((double(y) / height - 0.5) * Pi);
    for (int x = 0; x < width; ++x)
    {
      sum += *static_cast<float*>(image->GetScalarPointer(x, y, 0)) * band * 2.0 * Pi / width;
    }
  }
  return sum;
}
}

TEST(SkySource, UniformSkyOfRadianceOneMakesWhiteSurfacesOne)
{
  vtkNew<vtkGISkySource> sky;
  sky->SetColor(1.0, 0.5, 0.25);
  sky->SetStrength(2.0);
  for (const double elevation : { 90.0, 10.0, -60.0 })
  {
    const Color found = Irradiance(sky, elevation, 30.0);
    EXPECT_NEAR(found[0] / Pi, 2.0, 2e-4);
    EXPECT_NEAR(found[1] / Pi, 1.0, 1e-4);
    EXPECT_NEAR(found[2] / Pi, 0.5, 1e-4);
  }
  EXPECT_EQ(sky->GetSun(), nullptr);
}

TEST(SkySource, GradientBlendsItsThreeColors)
{
  vtkNew<vtkGISkySource> sky;
  sky->SetKindToGradient();
  sky->SetZenithColor(1.0, 2.0, 3.0);
  sky->SetHorizonColor(0.5, 0.5, 0.5);
  sky->SetGroundColor(0.1, 0.0, 0.0);
  EXPECT_NEAR(Radiance(sky, 90.0, 0.0)[2], 3.0, 0.01);
  EXPECT_NEAR(Radiance(sky, 0.01, 200.0)[1], 0.5, 0.01);
  EXPECT_NEAR(Radiance(sky, -90.0, 0.0)[0], 0.1, 0.01);
  EXPECT_NEAR(Radiance(sky, 30.0, 77.0)[0], 0.75, 0.02)
    << "half of the blend where the sine is 0.5";
  EXPECT_NEAR(Irradiance(sky, 90.0, 0.0)[1] / Pi, 0.3 * 0.5 + 0.7 * 2.0, 1e-3);
}

// Whatever their size and softness, and wherever they are: also across the seam of the image and at its pole.
TEST(SkySource, BoxesHaveThePowerOfTheirSolidAngle)
{
  struct
  {
    double Elevation, Azimuth, Width, Height, Radius, Softness, SolidAngle;
  } const boxes[] = {
    { 30.0, 45.0, 40.0, 20.0, 0.0, 0.0,
      4.0 * std::asin(std::sin(20 * Pi / 180) * std::sin(10 * Pi / 180)) },
    { 0.0, 270.0, 30.0, 30.0, 0.0, 1.0, 4.0 * std::asin(std::pow(std::sin(15 * Pi / 180), 2.0)) },
    { 90.0, 0.0, 170.0, 170.0, 0.0, 0.3, 4.0 * std::asin(std::pow(std::sin(85 * Pi / 180), 2.0)) },
    { -20.0, 10.0, 0.0, 0.0, 25.0, 0.2, 2.0 * Pi * (1.0 - std::cos(25 * Pi / 180)) },
    { 45.0, 180.0, 0.0, 0.0, 0.2, 0.0, 2.0 * Pi * (1.0 - std::cos(0.2 * Pi / 180)) },
    { 0.0, 0.0, 0.0, 0.0, 180.0, 0.0, 4.0 * Pi },
  };
  for (const auto& row : boxes)
  {
    vtkNew<vtkGISkySource> sky;
    sky->SetStrength(0.0);
    vtkNew<vtkGISoftBox> box;
    box->SetElevation(row.Elevation);
    box->SetAzimuth(row.Azimuth);
    box->SetWidth(row.Width);
    box->SetHeight(row.Height);
    box->SetRadius(row.Radius);
    box->SetSoftness(row.Softness);
    box->SetRadiance(7.0);
    sky->AddSoftBox(box);
    EXPECT_NEAR(box->GetSolidAngle(), row.SolidAngle, 1e-9 + 1e-6 * row.SolidAngle);
    EXPECT_NEAR(Power(sky), 7.0 * row.SolidAngle, 1e-4 * 7.0 * row.SolidAngle);
    const double middle = Radiance(sky, row.Elevation, row.Azimuth)[0];
    if (row.SolidAngle > 0.1)
    {
      EXPECT_NEAR(middle, 7.0, 0.5) << "the radiance in the middle of a box larger than pixels";
    }
  }
}

TEST(SkySource, BoxesCanBeRemoved)
{
  vtkNew<vtkGISkySource> sky;
  vtkNew<vtkGISoftBox> box;
  sky->AddSoftBox(box);
  const double bright = Radiance(sky, 45.0, 0.0)[0];
  box->SetAzimuth(180.0);
  EXPECT_EQ(Radiance(sky, 45.0, 0.0)[0], 1.0f);
  EXPECT_EQ(Radiance(sky, 45.0, 180.0)[0], bright);
  EXPECT_EQ(sky->GetNumberOfSoftBoxes(), 1);
  EXPECT_EQ(sky->GetSoftBox(0), box.Get());
  EXPECT_EQ(sky->GetSoftBox(1), nullptr);
  sky->RemoveSoftBox(box);
  EXPECT_EQ(sky->GetNumberOfSoftBoxes(), 0);
  EXPECT_EQ(Radiance(sky, 45.0, 180.0)[0], 1.0f);
}

// References: the worked example of Reda and Andreas 2004, Solar Position Algorithm for Solar Radiation Applications
// (without refraction), and values of NREL's program spa.c.
TEST(SkySource, SunIsWhereTheAlmanacHasIt)
{
  double days = 0.0;
  ASSERT_TRUE(penumbra::ParseTime("2003-10-17T12:30:30-07:00", days));
  const penumbra::SunPosition golden = penumbra::FindSun(39.742476, -105.1786, days);
  EXPECT_NEAR(golden.Elevation, 39.872046, 0.01);
  EXPECT_NEAR(golden.Azimuth, 194.340241, 0.01);
  struct
  {
    const char* Place;
    double Latitude, Longitude;
    const char* Time;
    double Azimuth, Zenith;
  } const rows[] = {
    { "Auckland", -36.840556, 174.74, "2010-12-15T21:30:00Z", 81.096955, 38.086833 },
    { "Brasilia", -15.793889, -47.882778, "2010-06-15T12:30:00Z", 46.250557, 55.629466 },
    { "Singapore", 1.283333, 103.833333, "2010-03-15T06:30:00Z", 259.794538, 19.383306 },
    { "Longyearbyen, by night", 78.22, 15.65, "2010-06-15T21:30:00Z", 339.394774, 77.579648 },
  };
  for (const auto& row : rows)
  {
    vtkNew<vtkGISkySource> sky;
    ASSERT_TRUE(sky->SetSunByTime(row.Latitude, row.Longitude, row.Time));
    std::printf("%s: elevation %.4f (%.4f), azimuth %.4f (%.4f)\n", row.Place,
      sky->GetSunElevation(), 90.0 - row.Zenith, sky->GetSunAzimuth(), row.Azimuth);
    EXPECT_NEAR(sky->GetSunElevation(), 90.0 - row.Zenith, 0.01) << row.Place;
    EXPECT_NEAR(sky->GetSunAzimuth(), row.Azimuth, 0.01) << row.Place;
  }
}

TEST(SkySource, DaylightLooksLikeTheSky)
{
  vtkNew<vtkGISkySource> sky;
  sky->SetKindToDaylight();
  sky->SetSunAzimuth(90.0);
  struct
  {
    double Elevation;
    bool Low;
  } const suns[] = { { 60.0, false }, { 30.0, false }, { 3.0, true } };
  for (const auto& sun : suns)
  {
    sky->SetSunElevation(sun.Elevation);
    const Color zenith = Radiance(sky, 90.0, 0.0);
    const Color besideSun = Radiance(sky, sun.Elevation + 8.0, 90.0);
    const Color opposite = Radiance(sky, sun.Elevation + 8.0, 270.0);
    const Color horizon = Radiance(sky, 1.0, 90.0);
    const Color level = Irradiance(sky, 90.0, 0.0);
    vtkLight* light = sky->GetSun();
    const double direct = light->GetIntensity() * Pi * std::sin(sun.Elevation * Pi / 180.0);
    std::printf(
      "sun %2.0f: zenith blue/red %.2f, horizon blue/red %.2f, luminance beside the sun / "
      "zenith %.2f, / opposite %.2f, sky %.3f of the irradiance\n",
      sun.Elevation, zenith[2] / zenith[0], horizon[2] / horizon[0],
      Luminance(besideSun) / Luminance(zenith), Luminance(besideSun) / Luminance(opposite),
      level[1] / (level[1] + direct * light->GetDiffuseColor()[1]));
    EXPECT_GT(zenith[2], 1.3 * zenith[0]) << "blue";
    EXPECT_GT(Luminance(besideSun), 1.5 * Luminance(opposite));
    EXPECT_GT(zenith[2] / zenith[0], 1.2 * horizon[2] / horizon[0]);
    if (sun.Low)
    {
      EXPECT_GT(horizon[0], 2.0 * horizon[2]) << "red";
      EXPECT_GT(light->GetDiffuseColor()[0], 3.0 * light->GetDiffuseColor()[2]);
    }
    // The ground reflects what falls on it.
    const Color ground = Radiance(sky, -45.0, 0.0);
    EXPECT_NEAR(ground[1], 0.3 * (level[1] + direct * light->GetDiffuseColor()[1]) / Pi, 0.002);
  }
  // Haze turns the sky white and the sun dim.
  sky->SetSunElevation(60.0);
  const Color clear = Radiance(sky, 90.0, 0.0);
  const double strong = sky->GetSun()->GetIntensity();
  sky->SetTurbidity(8.0);
  const Color hazy = Radiance(sky, 90.0, 0.0);
  EXPECT_LT(hazy[2] / hazy[0], 0.8 * clear[2] / clear[0]);
  EXPECT_LT(sky->GetSun()->GetIntensity(), 0.7 * strong);
}

TEST(SkySource, SunStandsWhereItIsSet)
{
  vtkNew<vtkGISkySource> sky;
  sky->SetKindToDaylight();
  sky->SetSunElevation(0.0);
  sky->SetSunAzimuth(90.0);
  const auto expect = [&](double x, double y, double z) {
    const double* place = sky->GetSun()->GetPosition();
    EXPECT_NEAR(place[0], x, 1e-9);
    EXPECT_NEAR(place[1], y, 1e-9);
    EXPECT_NEAR(place[2], z, 1e-9);
  };
  expect(1.0, 0.0, 0.0); // east, on a map
  sky->SetRotation(90.0);
  expect(0.0, -1.0, 0.0);
  sky->SetRotation(0.0);
  sky->SetUp(0.0, 1.0, 0.0); // north is vertical, so -z replaces it
  expect(1.0, 0.0, 0.0);
  sky->SetSunAzimuth(0.0);
  expect(0.0, 0.0, -1.0);
  EXPECT_EQ(vtkGILightShape::GetShape(sky->GetSun()), vtkGILightShape::ANGLE);
  sky->FollowCameraOn();
  expect(0.0, 0.0, 1.0); // toward the camera, in its coordinates
  EXPECT_TRUE(sky->GetSun()->LightTypeIsCameraLight());
}

TEST(SkySource, SunBelowTheHorizonLeavesDusk)
{
  vtkNew<vtkGISkySource> sky;
  sky->SetKindToDaylight();
  double before = 1.0;
  for (const double elevation : { 2.0, -2.0, -6.0, -30.0 })
  {
    sky->SetSunElevation(elevation);
    const double now = Luminance(Irradiance(sky, 90.0, 0.0));
    EXPECT_GE(now, 0.0);
    EXPECT_LT(now, before);
    EXPECT_EQ(sky->GetSun()->GetSwitch(), elevation > 0.0);
    before = now;
  }
  EXPECT_LT(before, 1e-6);
}

TEST(SkySource, RefusesAndLimitsHostileNumbers)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkGISkySource> sky;
  vtkNew<vtkGISoftBox> box;
  sky->SetStrength(nan);
  sky->SetColor(1.0, nan, 1.0);
  sky->SetColor(-1.0, 0.0, 1.0);
  sky->SetSunElevation(std::numeric_limits<double>::infinity());
  sky->SetUp(0.0, 0.0, 0.0);
  sky->SetNorth(nan, 0.0, 0.0);
  sky->AddSoftBox(nullptr);
  sky->ApplyTo(nullptr);
  box->SetWidth(nan);
  box->SetColor(0.0, 0.0, nan);
  EXPECT_FALSE(sky->SetSunByTime(91.0, 0.0, "2026-06-21T16:00Z"));
  EXPECT_FALSE(sky->SetSunByTime(0.0, nan, "2026-06-21T16:00Z"));
  for (const char* time : { "", "yesterday", "2026-02-29T12:00Z", "2026-06-21T24:00Z",
         "2026-06-21T12:00+2", "2026-06-21T12:00Zulu", "1949-12-31T12:00Z", "2026-06-21" })
  {
    EXPECT_FALSE(sky->SetSunByTime(0.0, 0.0, time)) << time;
  }
  EXPECT_FALSE(sky->SetSunByTime(0.0, 0.0, nullptr));
  EXPECT_EQ(TakeMessages().size(), 21u);
  EXPECT_EQ(sky->GetStrength(), 1.0);
  EXPECT_EQ(sky->GetColor()[1], 1.0);

  sky->SetImageWidth(0);
  box->SetWidth(0.0);
  box->SetHeight(1e9);
  box->SetRadius(-1.0);
  box->SetRadiance(-1.0);
  box->SetSoftness(5.0);
  sky->AddSoftBox(box);
  sky->SetKindToDaylight();
  sky->SetTurbidity(0.0);
  sky->SetGroundAlbedo(5.0, 0.0, 0.0);
  EXPECT_EQ(sky->GetImage()->GetDimensions()[0], 16);
  EXPECT_GT(box->GetWidth(), 0.0);
  EXPECT_EQ(box->GetRadiance(), 0.0);
  EXPECT_EQ(sky->GetTurbidity(), 1.0);
  EXPECT_EQ(sky->GetGroundAlbedo()[0], 1.0);
  EXPECT_TRUE(std::isfinite(Power(sky)));
  EXPECT_TRUE(TakeMessages().empty());
}
