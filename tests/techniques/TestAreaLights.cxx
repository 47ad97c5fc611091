// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Lights with shapes of their own: their light and shadows against closed forms, by every technique.
#include "AreaStage.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationIntegerKey.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

#include <cstdio>
#include <limits>

using namespace penumbra_test;

namespace
{
using AreaLights = AreaStage;

TEST_F(AreaLights, LightOfFlatOnesMatchesClosedForms)
{
  const auto check = [this](const char* name, const FlatLight& light) {
    const auto expected = this->Expected(light);
    const double drawn = LargestDifference(this->ShineBy("", 1), expected);
    const double traced = LargestDifference(
      Blocks(this->ShineBy("path-tracing", 32), 16, 16), Blocks(expected, 16, 16));
    std::printf("%-24s rasterizer %.5f, path tracer %.5f\n", name, drawn, traced);
    EXPECT_LT(drawn, 0.0001) << name;
    EXPECT_LT(traced, 0.005) << name;
  };
  check("rectangle 2 x 1, turned", this->Rectangle(2.0, 1.0, 30.0));
  check("rectangle 4 x 3", this->Rectangle(4.0, 3.0));
  check("disc of radius 1", this->Disc(1.0));
  check("disc of radius 0.05", this->Disc(0.05));
  TakeMessages();
}

// On the axis of a disc: pi L R^2 / (R^2 + h^2).
TEST_F(AreaLights, LightOnTheAxisOfADisc)
{
  for (const double radius : { 0.01, 0.5, 3.0 })
  {
    const double expected = FloorLight(this->Disc(radius), glm::dvec3(0.0), 0.0, 0.0);
    EXPECT_NEAR(expected, 1.0 / (radius * radius + Height * Height), 1e-5);
    const auto values = this->ShineBy("", 1);
    const double middle = values[Side / 2 * Side + Side / 2];
    EXPECT_NEAR(middle / expected, 1.0, 0.005) << radius;
  }
}

// A wall through the light's middle sees half of it: the horizon clips the shapes. The path tracer clips nothing.
TEST_F(AreaLights, HorizonClipsShapes)
{
  this->Floor->SetOrientation(0.0, 75.0, 0.0);
  this->Lamp->SetPosition(0.6, 0.0, 0.6);
  this->Lamp->SetFocalPoint(0.0, 0.0, 0.0);
  this->Scene.Renderer->GetActiveCamera()->SetPosition(2.0, 0.0, 0.5);
  this->Scene.Renderer->GetActiveCamera()->SetParallelScale(0.5);
  this->Scene.Renderer->GetActiveCamera()->SetClippingRange(0.1, 9.0);
  for (const int shape : { 0, 1, 2 })
  {
    if (shape == 0)
    {
      vtkGILightShape::SetRectangle(this->Lamp, 1.6, 1.2);
    }
    else if (shape == 1)
    {
      vtkGILightShape::SetDisc(this->Lamp, 0.8);
    }
    else
    {
      vtkGILightShape::SetSphere(this->Lamp, 0.5);
    }
    const auto drawn = Blocks(this->ShineBy("", 1), 8, 8);
    const auto traced = Blocks(this->ShineBy("path-tracing", 128), 8, 8);
    const double difference = LargestDifference(drawn, traced);
    std::printf("horizon, shape %d: %.5f\n", shape, difference);
    EXPECT_LT(difference, 0.006) << shape;
  }
  TakeMessages();
}

TEST_F(AreaLights, HalfCoveredLightMatchesThePolygonFormula)
{
  this->Cover(1.0);
  const auto check = [this](const char* name, const FlatLight& light) {
    const auto expected = Blocks(this->Expected(light, 1.0), 4, 64);
    for (const char* technique : { "ray-traced-shadows", "path-tracing" })
    {
      const int frames = *technique == 'r' ? 8 : 128;
      const double error =
        LargestDifference(Blocks(this->ShineBy(technique, frames), 4, 64), expected);
      std::printf("%s, half covered, %s: %.5f\n", name, technique, error);
      EXPECT_LT(error, 0.005) << name << " " << technique;
    }
  };
  check("rectangle", this->Rectangle(1.0, 0.6, 20.0));
  check("disc", this->Disc(0.5));
  TakeMessages();
}

double PositionOf(const std::vector<double>& profile, double level)
{
  for (std::size_t i = 1; i < profile.size(); ++i)
  {
    if (profile[i] >= level)
    {
      return i - (profile[i] - level) / (profile[i] - profile[i - 1]);
    }
  }
  return 0.0;
}

// The penumbra of an edge across a rectangle is a ramp as wide as the rectangle is long, times the ratio of distances.
TEST_F(AreaLights, PenumbraIsAsWideAsTheLight)
{
  const double height = 1.0;
  for (const double length : { 0.4, 1.0 })
  {
    this->Rectangle(length, 0.2);
    const auto lit = Blocks(this->ShineBy("", 1), 1, 64);
    vtkActor* cover = this->Cover(height);
    const double expected = length * height / (Height - height);
    for (const char* technique : { "shadow-maps", "ray-traced-shadows", "path-tracing" })
    {
      const int frames = *technique == 'p' ? 64 : 8;
      auto profile = Blocks(this->ShineBy(technique, frames), 1, 64);
      for (std::size_t i = 0; i < profile.size(); ++i)
      {
        profile[i] /= lit[i];
      }
      const double width =
        (PositionOf(profile, 0.9) - PositionOf(profile, 0.1)) / 0.8 / Side * Width;
      std::printf(
        "rectangle %.1f long, %-18s: penumbra %.4f of %.4f\n", length, technique, width, expected);
      EXPECT_NEAR(width / expected, 1.0, 0.1) << technique;
    }
    this->Scene.Renderer->RemoveActor(cover);
  }
  TakeMessages();
}

// Each light has its own size, whatever the technique's parameter says.
TEST_F(AreaLights, ShapesReplaceTheTechniquesSize)
{
  this->Cover(1.0);
  for (const char* technique : { "shadow-maps", "ray-traced-shadows" })
  {
    this->Pass->GetTechnique(technique)->SetParameter("light-radius", 0.5);
    const auto hardness = [&] {
      const auto profile = Blocks(this->ShineBy(technique, 2), 1, 64);
      int between = 0;
      for (const double value : profile)
      {
        between += value > 0.05 * profile.back() && value < 0.5 * profile.back();
      }
      return between;
    };
    vtkGILightShape::Remove(this->Lamp);
    const int soft = hardness();
    vtkGILightShape::SetPoint(this->Lamp);
    const int hard = hardness();
    EXPECT_GT(soft, hard + 2) << technique;
  }
  TakeMessages();
}

TEST_F(AreaLights, HighlightsMatchThePathTracer)
{
  vtkProperty* property = this->Floor->GetProperty();
  this->Scene.Renderer->GetActiveCamera()->SetPosition(-1.0, 0.3, 0.8);
  this->Scene.Renderer->GetActiveCamera()->SetClippingRange(0.05, 5.0);
  const auto compare = [this](const char* name, double limit) {
    const auto drawn = Blocks(this->ShineBy("", 1), 4, 4);
    const auto traced = Blocks(this->ShineBy("path-tracing", 96), 4, 4);
    const double difference = LargestDifference(drawn, traced);
    std::printf("highlight, %s: %.4f\n", name, difference);
    EXPECT_LT(difference, limit) << name << "\n"
                                 << testing::PrintToString(drawn) << "\n"
                                 << testing::PrintToString(traced);
  };
  property->SetDiffuse(0.2);
  property->SetSpecular(1.0);
  for (const bool round : { false, true })
  {
    round ? vtkGILightShape::SetDisc(this->Lamp, 0.6)
          : vtkGILightShape::SetRectangle(this->Lamp, 1.2, 0.7, 20.0);
    property->SetInterpolationToPhong();
    for (const double power : { 3.0, 20.0, 51.0 })
    {
      property->SetSpecularPower(power);
      compare(("Phong " + std::to_string(power)).c_str(), 0.02);
    }
    property->SetInterpolationToPBR();
    property->SetMetallic(1.0);
    for (const double roughness : { 0.3, 0.6 })
    {
      property->SetRoughness(roughness);
      compare(("PBR " + std::to_string(roughness)).c_str(), 0.12);
    }
  }
  TakeMessages();
}

// A rectangle that shines at the ceiling lights the floor by reflection only, about half as much as a point light would.
// Between two open planes DDGI is too bright, with a point light as well.
TEST_F(AreaLights, DDGIReflectsTheLightOfARectangle)
{
  this->Floor->GetProperty()->SetDiffuse(0.7);
  vtkActor* ceiling = AddFloor(this->Scene, -6.0, 6.0, -6.0, 6.0, 3.0);
  ceiling->GetProperty()->SetColor(0.7, 0.7, 0.7);
  this->Lamp->SetPosition(0.0, 0.0, 1.0);
  this->Lamp->SetFocalPoint(0.0, 0.0, 3.0);
  vtkGILightShape::SetRectangle(this->Lamp, 2.0, 1.4);
  const double traced = Blocks(this->ShineBy("path-tracing", 32), Side, Side).front();
  const double drawn = Blocks(this->ShineBy("ddgi", 40), Side, Side).front();
  std::printf("reflected: DDGI %.5f, path tracer %.5f\n", drawn, traced);
  EXPECT_NEAR(drawn / traced, 1.0, 0.23);
  TakeMessages();
}

// A shape far away looks like a point; a shape with its size removed is one, exactly.
TEST_F(AreaLights, SmallShapesArePoints)
{
  const auto point = this->ShineBy("", 1);
  vtkGILightShape::SetSphere(this->Lamp, 1e-3);
  EXPECT_LT(LargestDifference(this->ShineBy("", 1), point), 1e-4);
  vtkGILightShape::SetSphere(this->Lamp, 0.5);
  EXPECT_LT(LargestDifference(this->ShineBy("", 1), point), 1e-3); // all of it is above the floor
  vtkGILightShape::Remove(this->Lamp);
  EXPECT_EQ(this->ShineBy("", 1), point);
}

TEST_F(AreaLights, BadSizesAreErrorsAndNeverShow)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const auto point = this->ShineBy("", 1);
  int refused = 0;
  for (const double bad : { -1.0, nan, infinite, 1e16 })
  {
    vtkGILightShape::SetDisc(this->Lamp, bad);
    vtkGILightShape::SetSphere(this->Lamp, bad);
    vtkGILightShape::SetAngle(this->Lamp, bad);
    vtkGILightShape::SetRectangle(this->Lamp, bad, 1.0);
    vtkGILightShape::SetRectangle(this->Lamp, 1.0, bad);
    refused += 5;
  }
  vtkGILightShape::SetRectangle(this->Lamp, 1.0, 1.0, nan);
  EXPECT_EQ(TakeMessages().size(), static_cast<std::size_t>(refused + 1));
  EXPECT_EQ(vtkGILightShape::GetShape(this->Lamp), vtkGILightShape::NONE);
  vtkGILightShape::SetRectangle(this->Lamp, 1.0, 0.0);
  EXPECT_EQ(vtkGILightShape::GetShape(this->Lamp), vtkGILightShape::POINT);
  EXPECT_EQ(this->ShineBy("", 1), point);
  vtkInformation* information = this->Lamp->GetInformation();
  for (const int shape : { 2, 3, 4, 5, 77, -3 })
  {
    for (const double bad : { nan, -1.0, infinite, 1e300, 1e-300 })
    {
      const double size[] = { bad, bad, bad };
      information->Set(vtkGILightShape::SHAPE(), shape);
      information->Set(vtkGILightShape::SIZE(), size, 3);
      this->Lamp->Modified();
      for (const char* technique : { "", "shadow-maps", "ray-traced-shadows", "path-tracing" })
      {
        for (const double value : this->ShineBy(technique, 1))
        {
          ASSERT_TRUE(std::isfinite(value)) << shape << " " << bad << " " << technique;
        }
      }
    }
    information->Remove(vtkGILightShape::SIZE());
    this->Lamp->Modified();
    EXPECT_EQ(this->ShineBy("", 1), point);
  }
  vtkGILightShape::SetDisc(nullptr, 1.0);
  EXPECT_EQ(vtkGILightShape::GetShape(nullptr), vtkGILightShape::NONE);
}

// A light on, in and below the floor.
TEST_F(AreaLights, NoPlaceMakesNoise)
{
  for (const double z : { 0.0, 1e-6, -0.5 })
  {
    this->Lamp->SetPosition(0.0, 0.0, z);
    this->Lamp->SetFocalPoint(0.0, 1.0, z);
    for (const int shape : { 0, 1, 2 })
    {
      shape == 0     ? vtkGILightShape::SetRectangle(this->Lamp, 1.0, 1.0)
        : shape == 1 ? vtkGILightShape::SetDisc(this->Lamp, 0.5)
                     : vtkGILightShape::SetSphere(this->Lamp, 0.5);
      for (const char* technique : { "", "shadow-maps", "ray-traced-shadows", "path-tracing" })
      {
        for (const double value : this->ShineBy(technique, 1))
        {
          ASSERT_TRUE(std::isfinite(value) && value >= 0.0) << z << " " << shape << technique;
        }
      }
    }
  }
  TakeMessages();
}

TEST_F(AreaLights, ShapeIsPartOfTheLight)
{
  const vtkMTimeType before = this->Lamp->GetMTime();
  vtkGILightShape::SetRectangle(this->Lamp, 2.0, 1.0, 15.0);
  EXPECT_GT(this->Lamp->GetMTime(), before);
  EXPECT_EQ(vtkGILightShape::GetShape(this->Lamp), vtkGILightShape::RECTANGLE);
  EXPECT_EQ(vtkGILightShape::GetWidth(this->Lamp), 2.0);
  EXPECT_EQ(vtkGILightShape::GetHeight(this->Lamp), 1.0);
  EXPECT_EQ(vtkGILightShape::GetTurn(this->Lamp), 15.0);
  EXPECT_EQ(vtkGILightShape::GetRadius(this->Lamp), 0.0);
  vtkNew<vtkLight> other;
  other->DeepCopy(this->Lamp);
  EXPECT_EQ(vtkGILightShape::GetShape(other), vtkGILightShape::RECTANGLE);
  vtkGILightShape::Remove(other);
  vtkGILightShape::Copy(this->Lamp, other);
  EXPECT_EQ(vtkGILightShape::GetWidth(other), 2.0);
  vtkGILightShape::SetAngle(this->Lamp, 6.0);
  EXPECT_EQ(vtkGILightShape::GetAngle(this->Lamp), 6.0);
  EXPECT_EQ(vtkGILightShape::GetWidth(other), 2.0);
  this->Scene.Window->Render();
  EXPECT_NE(std::string(this->Pass->GetNotes()).find("has no effect"), std::string::npos);
  vtkGILightShape::Remove(this->Lamp);
  EXPECT_EQ(vtkGILightShape::GetShape(this->Lamp), vtkGILightShape::NONE);
  this->Scene.Window->Render();
  EXPECT_STREQ(this->Pass->GetNotes(), "");
}
}
