// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SceneSurfaces.h"

#include "base/Matrices.h"
#include "rays/SkyPictures.h"

#include <glm/gtc/constants.hpp>
#include <vtkOpenGLRenderer.h>

#include <algorithm>
#include <cmath>

namespace penumbra::radiosity
{
namespace
{
Sky MakeSky(vtkRenderer* renderer)
{
  if (!renderer->GetUseImageBasedLighting() || !renderer->GetEnvironmentTexture())
  {
    return {};
  }
  const auto sky =
    std::make_shared<const SkyPictures>(SkyPictures::Of(renderer, SkyDecoding::Of(renderer)));
  if (sky->Width == 0)
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
    const int x = std::clamp(static_cast<int>(u * sky->Width), 0, sky->Width - 1);
    const int y = std::clamp(static_cast<int>(v * sky->Height), 0, sky->Height - 1);
    return glm::max(Color(sky->Matte[static_cast<std::size_t>(y) * sky->Width + x]), 0.0);
  };
}
}

Illumination GatherLights(vtkRenderer* renderer, tool::Reporter& reporter)
{
  Illumination result;
  renderer->UpdateLightsGeometryToFollowCamera();
  LightTable table;
  table.Collect(vtkOpenGLRenderer::SafeDownCast(renderer));
  bool headlights = false;
  for (const Light& light : table.Lights())
  {
    headlights = headlights || light.Headlight;
    if (!light.Headlight && light.Color != Color(0.0))
    {
      result.Lights.push_back(light);
    }
  }
  if (headlights)
  {
    reporter.Note("the headlight is left out: it would move with the view");
  }
  result.Surroundings = MakeSky(renderer);
  return result;
}
}
