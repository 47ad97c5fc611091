// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SceneLights.h"

#include "rays/TexturePixels.h"

#include <glm/gtc/constants.hpp>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>

namespace penumbra::radiosity
{
namespace
{
Point ToPoint(const double* v)
{
  return { v[0], v[1], v[2] };
}

Lamp MakeLamp(vtkLight* light)
{
  Lamp lamp;
  lamp.Strength = ToPoint(light->GetDiffuseColor()) * (light->GetIntensity() * glm::pi<double>());
  lamp.Positional = light->GetPositional() != 0;
  double at[3];
  double focal[3];
  light->GetTransformedPosition(at);
  light->GetTransformedFocalPoint(focal);
  lamp.Position = ToPoint(at);
  const Point travel = ToPoint(focal) - lamp.Position;
  lamp.Travel = glm::length(travel) > 0.0 ? glm::normalize(travel) : lamp.Travel;
  lamp.Attenuation = ToPoint(light->GetAttenuationValues());
  constexpr double none = 90.0; // degrees: no cone, in VTK's convention
  if (lamp.Positional && light->GetConeAngle() < none)
  {
    lamp.ConeCosine = std::cos(glm::radians(light->GetConeAngle()));
    lamp.Exponent = light->GetExponent();
  }
  return lamp;
}

Sky MakeSky(vtkRenderer* renderer, std::vector<std::string>& notes)
{
  vtkTexture* texture =
    renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  if (!texture)
  {
    return {};
  }
  if (texture->GetCubeMap())
  {
    notes.emplace_back("the environment is left out: as a cube map it is not read");
    return {};
  }
  auto pixels = std::make_shared<TexturePixels>(ReadTexturePixels(texture));
  if (pixels->Width == 0)
  {
    return {};
  }
  const Point right = glm::normalize(ToPoint(renderer->GetEnvironmentRight()));
  const Point up = glm::normalize(ToPoint(renderer->GetEnvironmentUp()));
  const Point front = glm::cross(right, up);
  return [=](const Point& direction) {
    const Point d(glm::dot(direction, right), glm::dot(direction, up), glm::dot(direction, front));
    const double u = std::atan2(d.z, d.x) / (2.0 * glm::pi<double>()) + 0.5;
    const double v = std::asin(std::clamp(d.y, -1.0, 1.0)) / glm::pi<double>() + 0.5;
    return glm::max(
      Color(pixels->At(std::clamp(static_cast<int>(u * pixels->Width), 0, pixels->Width - 1),
        std::clamp(static_cast<int>(v * pixels->Height), 0, pixels->Height - 1))),
      0.0);
  };
}
}

Illumination GatherLights(vtkRenderer* renderer, std::vector<std::string>& notes)
{
  Illumination result;
  renderer->UpdateLightsGeometryToFollowCamera();
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  int headlights = 0;
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (light->GetSwitch() && light->LightTypeIsHeadlight())
    {
      ++headlights;
    }
    else if (light->GetSwitch() && light->GetIntensity() > 0.0)
    {
      result.Lamps.push_back(MakeLamp(light));
    }
  }
  if (headlights > 0)
  {
    notes.emplace_back("the headlight is left out: it would move with every view of the solution");
  }
  result.Surroundings = MakeSky(renderer, notes);
  return result;
}
}
