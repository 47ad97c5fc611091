// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SceneSurfaces.h"

#include "base/Matrices.h"
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
DeltaLight MakeLight(vtkLight* light)
{
  DeltaLight result;
  result.Strength = ToVec3(light->GetDiffuseColor()) * (light->GetIntensity() * glm::pi<double>());
  result.Positional = light->GetPositional() != 0;
  double at[3];
  double focal[3];
  light->GetTransformedPosition(at);
  light->GetTransformedFocalPoint(focal);
  result.Position = ToVec3(at);
  const Point travel = ToVec3(focal) - result.Position;
  result.Travel = glm::length(travel) > 0.0 ? glm::normalize(travel) : result.Travel;
  result.Attenuation = ToVec3(light->GetAttenuationValues());
  constexpr double none = 90.0; // degrees, VTK's convention for no cone
  if (result.Positional && light->GetConeAngle() < none)
  {
    result.ConeCosine = std::cos(glm::radians(light->GetConeAngle()));
    result.Exponent = light->GetExponent();
  }
  return result;
}

Sky MakeSky(vtkRenderer* renderer, tool::Reporter& reporter)
{
  vtkTexture* texture =
    renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  if (!texture)
  {
    return {};
  }
  if (texture->GetCubeMap())
  {
    reporter.Note("the environment is left out: cube maps are not supported");
    return {};
  }
  auto pixels = std::make_shared<TexturePixels>(ReadTexturePixels(texture));
  if (pixels->Width == 0)
  {
    return {};
  }
  const Point right = glm::normalize(ToVec3(renderer->GetEnvironmentRight()));
  const Point up = glm::normalize(ToVec3(renderer->GetEnvironmentUp()));
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

Illumination GatherLights(vtkRenderer* renderer, tool::Reporter& reporter)
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
      result.Lights.push_back(MakeLight(light));
    }
  }
  if (headlights > 0)
  {
    reporter.Note("the headlight is left out: it would move with the view");
  }
  result.Surroundings = MakeSky(renderer, reporter);
  return result;
}
}
