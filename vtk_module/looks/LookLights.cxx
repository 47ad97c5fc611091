// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/LookLights.h"

#include "base/Matrices.h"
#include "looks/Vertical.h"

#include "vtkBoundingBox.h"
#include "vtkGILightShape.h"
#include "vtkLight.h"
#include "vtkRenderer.h"

namespace penumbra
{
namespace
{
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
  : Described(*look.Lights)
{
  for (const LookLight& described : this->Described)
  {
    const auto light = vtkSmartPointer<vtkLight>::New();
    light->SetColor(described.Color.data());
    light->SetIntensity(described.Intensity);
    if (described.Angle > 0.0)
    {
      vtkGILightShape::SetAngle(light, described.Angle);
    }
    // Light from the camera itself needs no shadow, as the camera sees none of it.
    if (look.FollowsCamera && described.Elevation == 0.0 && described.Azimuth == 0.0)
    {
      light->SetLightTypeToHeadlight();
    }
    else if (look.FollowsCamera)
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

void LookLights::Place(vtkRenderer* renderer, const glm::dvec3& up)
{
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
    const glm::dvec3 position = ToVec3(center) + distance * Direction(this->Described[i], up);
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
