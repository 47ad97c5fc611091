// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/LookLights.h"

#include "base/Matrices.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkRenderer.h"

namespace penumbra
{
namespace
{
/// The coordinate axis nearest to a direction.
glm::dvec3 NearestAxis(const glm::dvec3& direction)
{
  glm::dvec3 axis(0.0);
  int largest = 0;
  for (int i = 1; i < 3; ++i)
  {
    largest = std::abs(direction[i]) > std::abs(direction[largest]) ? i : largest;
  }
  axis[largest] = direction[largest] < 0.0 ? -1.0 : 1.0;
  return axis;
}

/// The side from which things are seen by default: from +z where y is up, else from -y, as maps are from the south.
glm::dvec3 FrontOf(const glm::dvec3& up)
{
  return up.y != 0.0 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, -1.0, 0.0);
}

glm::dvec3 Direction(const LookLight& light, const glm::dvec3& up)
{
  const double elevation = glm::radians(light.Elevation);
  const double azimuth = glm::radians(light.Azimuth);
  const glm::dvec3 front = FrontOf(up);
  const glm::dvec3 right = glm::cross(up, front);
  return std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * right) +
    std::sin(elevation) * up;
}
}

LookLights::LookLights(const LookDescription& look, vtkRenderer* renderer)
  : Look(look)
{
  for (const LookLight& described : *look.Lights)
  {
    const auto light = vtkSmartPointer<vtkLight>::New();
    light->SetColor(described.Color.data());
    light->SetIntensity(described.Intensity);
    if (look.FollowsCamera)
    {
      light->SetLightTypeToCameraLight();
      light->SetDirectionAngle(described.Elevation, described.Azimuth);
    }
    renderer->AddLight(light);
    this->Lights.push_back(light);
  }
  renderer->AutomaticLightCreationOff();
  renderer->LightFollowCameraOn();
}

void LookLights::Place(vtkRenderer* renderer)
{
  if (this->Look.FollowsCamera)
  {
    return;
  }
  const glm::dvec3 up = this->Look.Up
    ? ToVec3(this->Look.Up->data())
    : NearestAxis(ToVec3(renderer->GetActiveCamera()->GetViewUp()));
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const vtkBoundingBox box(bounds);
  double center[3] = { 0, 0, 0 };
  if (box.IsValid())
  {
    box.GetCenter(center);
  }
  const double distance = box.IsValid() ? std::max(box.GetDiagonalLength(), 1e-30) : 1.0;
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    const glm::dvec3 position = ToVec3(center) + distance * Direction(this->Look.Lights->at(i), up);
    this->Lights[i]->SetFocalPoint(center);
    this->Lights[i]->SetPosition(position.x, position.y, position.z);
  }
}

void LookLights::RemoveFrom(vtkRenderer* renderer) const
{
  for (vtkLight* light : this->Lights)
  {
    renderer->RemoveLight(light);
  }
}
}
