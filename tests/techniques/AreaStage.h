// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A light with a shape over a floor, seen from above in a parallel projection, and the same light in closed form.
 */
#pragma once

#include "Messages.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGILightShape.h"
#include "vtkGIPass.h"
#include "vtkGITechnique.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace penumbra_test
{
/// A flat light: its centre, two vectors to its sides, and the direction in which it shines.
struct FlatLight
{
  glm::dvec3 Center{ 0.0 };
  glm::dvec3 Side{ 0.0 };
  glm::dvec3 Up{ 0.0 };
  bool Round = false;

  double Area() const
  {
    return (this->Round ? glm::pi<double>() : 4.0) * glm::length(this->Side) *
      glm::length(this->Up);
  }
  /// Corners, counterclockwise as seen from above; many for a disc.
  std::vector<glm::dvec3> Outline() const
  {
    std::vector<glm::dvec3> corners;
    const int count = this->Round ? 4000 : 4;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * glm::pi<double>() * (i + 0.5) / count;
      const glm::dvec2 place = this->Round
        ? glm::dvec2(std::cos(angle), std::sin(angle))
        : glm::dvec2(std::cos(angle) > 0.0 ? 1.0 : -1.0, std::sin(angle) > 0.0 ? 1.0 : -1.0);
      corners.push_back(this->Center + place.x * this->Side + place.y * this->Up);
    }
    return corners;
  }
};

/// The part of a polygon on one side of a plane through the origin.
inline std::vector<glm::dvec3> Clip(
  const std::vector<glm::dvec3>& polygon, const glm::dvec3& normal)
{
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3& a = polygon[i];
    const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
    const double above = glm::dot(a, normal);
    const double next = glm::dot(b, normal);
    if (above > 0.0)
    {
      kept.push_back(a);
    }
    if ((above > 0.0) != (next > 0.0))
    {
      kept.push_back(a + (above / (above - next)) * (b - a));
    }
  }
  return kept;
}

/// Lambert's formula (1760): irradiance of a polygon of unit radiance at the origin, of all its part above the horizon.
inline double PolygonIrradiance(const std::vector<glm::dvec3>& polygon, const glm::dvec3& normal)
{
  const std::vector<glm::dvec3> above = Clip(polygon, normal);
  double sum = 0.0;
  for (std::size_t i = 0; i < above.size(); ++i)
  {
    const glm::dvec3 a = glm::normalize(above[i]);
    const glm::dvec3 b = glm::normalize(above[(i + 1) % above.size()]);
    const glm::dvec3 across = glm::cross(a, b);
    const double sine = glm::length(across);
    sum += sine > 0.0 ? std::atan2(sine, glm::dot(a, b)) * glm::dot(across, normal) / sine : 0.0;
  }
  return 0.5 * std::abs(sum);
}

/// Irradiance divided by pi at a point of the floor, from a light of unit strength with quadratic attenuation, of which
/// the part beyond the plane x = edge at a height is visible. height: 0 for no occluder.
inline double FloorLight(const FlatLight& light, const glm::dvec3& at, double height, double edge)
{
  std::vector<glm::dvec3> outline = light.Outline();
  for (glm::dvec3& corner : outline)
  {
    corner -= at;
  }
  if (height > 0.0)
  {
    // The plane through the point and the edge.
    outline = Clip(outline, glm::dvec3(height, 0.0, at.x - edge));
  }
  return PolygonIrradiance(outline, { 0.0, 0.0, 1.0 }) / light.Area();
}

class AreaStage : public ::testing::Test
{
protected:
  static constexpr int Side = 64;
  static constexpr double Width = 4.0;  ///< of the picture
  static constexpr double Height = 2.0; ///< of the light

  void SetUp() override
  {
    this->Scene.Window->SetSize(Side, Side);
    this->Scene.Renderer->AutomaticLightCreationOff();
    this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Floor = AddFloor(this->Scene, -6.0, 6.0, -6.0, 6.0);
    this->Floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    this->Lamp->SetLightTypeToSceneLight();
    this->Lamp->SetPosition(0.0, 0.0, Height);
    this->Lamp->SetFocalPoint(0.0, 0.0, 0.0);
    this->Lamp->SetAttenuationValues(0.0, 0.0, 1.0);
    ShineAllRound(this->Lamp);
    this->Scene.Renderer->AddLight(this->Lamp);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(Width / 2.0);
    camera->SetPosition(0.0, 0.0, 0.5);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(0.1, 1.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Pass->KeepRadianceOn();
  }

  /// Cover the half x < 0 at a height.
  vtkActor* Cover(double height)
  {
    vtkActor* cover = AddFloor(this->Scene, -8.0, 0.0, -8.0, 8.0, height);
    cover->GetProperty()->SetColor(0.0, 0.0, 0.0);
    return cover;
  }

  FlatLight Disc(double radius)
  {
    vtkGILightShape::SetDisc(this->Lamp, radius);
    return { { 0.0, 0.0, Height }, { radius, 0.0, 0.0 }, { 0.0, radius, 0.0 }, true };
  }

  FlatLight Rectangle(double width, double height, double turn = 0.0)
  {
    vtkGILightShape::SetRectangle(this->Lamp, width, height, turn);
    const double angle = glm::radians(turn);
    const glm::dvec3 x(std::cos(angle), -std::sin(angle), 0.0);
    const glm::dvec3 y(std::sin(angle), std::cos(angle), 0.0);
    return { { 0.0, 0.0, Height }, 0.5 * width * x, 0.5 * height * y, false };
  }

  /// World position of a pixel's centre on the floor.
  static glm::dvec3 At(int x, int y)
  {
    return { ((x + 0.5) / Side - 0.5) * Width, ((y + 0.5) / Side - 0.5) * Width, 0.0 };
  }

  /// Mean radiance of some frames, or what the path tracer shows after them.
  std::vector<double> Shine(int frames, bool mean)
  {
    std::vector<double> values(Side * Side, 0.0);
    vtkNew<vtkImageData> radiance;
    for (int frame = 0; frame < frames; ++frame)
    {
      this->Scene.Window->Render();
      if (!mean && frame + 1 < frames)
      {
        continue;
      }
      EXPECT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, radiance));
      const auto* pixels = static_cast<const float*>(radiance->GetScalarPointer());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i] += pixels[4 * i] / (mean ? frames : 1);
      }
    }
    return values;
  }

  /// Radiance by one technique, or without any ("").
  std::vector<double> ShineBy(const std::string& technique, int frames)
  {
    if (!technique.empty())
    {
      this->Pass->GetTechnique(technique.c_str())->EnabledOn();
    }
    if (technique == "ray-traced-shadows")
    {
      this->Pass->GetTechnique("ray-traced-shadows")->SetParameter("samples", 16);
    }
    const auto values = this->Shine(technique.empty() ? 1 : frames, technique != "path-tracing");
    if (!technique.empty())
    {
      this->Pass->GetTechnique(technique.c_str())->EnabledOff();
    }
    return values;
  }

  /// Means of blocks of pixels, so that noise counts less.
  static std::vector<double> Blocks(const std::vector<double>& values, int width, int height)
  {
    std::vector<double> means;
    for (int y = 0; y < Side; y += height)
    {
      for (int x = 0; x < Side; x += width)
      {
        double sum = 0.0;
        for (int i = 0; i < width * height; ++i)
        {
          sum += values[(y + i / width) * Side + x + i % width];
        }
        means.push_back(sum / (width * height));
      }
    }
    return means;
  }

  /// Largest difference, as a share of the largest reference.
  static double LargestDifference(
    const std::vector<double>& values, const std::vector<double>& reference)
  {
    double largest = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      EXPECT_TRUE(std::isfinite(values[i]));
      largest = std::max(largest, std::abs(values[i] - reference[i]));
      most = std::max(most, reference[i]);
    }
    return largest / most;
  }

  std::vector<double> Expected(const FlatLight& light, double height = 0.0) const
  {
    std::vector<double> values;
    for (int i = 0; i < Side * Side; ++i)
    {
      values.push_back(FloorLight(light, At(i % Side, i / Side), height, 0.0));
    }
    return values;
  }

  Stage Scene;
  vtkNew<vtkLight> Lamp;
  vtkActor* Floor = nullptr;
  vtkSmartPointer<vtkGIPass> Pass;
};
}
