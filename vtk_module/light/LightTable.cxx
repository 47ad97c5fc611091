// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/LightTable.h"

#include "base/Matrices.h"
#include "light/LightShape.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"
#include "vtkTransform.h"

#include <glm/gtc/constants.hpp>

namespace penumbra
{
namespace
{
glm::dvec3 Transformed(vtkLinearTransform* transform, const glm::dvec3& vector)
{
  glm::dvec3 result;
  transform->TransformVector(&vector[0], &result[0]);
  return result;
}
}

void LightTable::Collect(vtkOpenGLRenderer* renderer)
{
  this->Entries.clear();
  this->Positional = false;
  this->Areas = false;
  this->Shapes = false;
  this->Misshapen = 0;
  vtkTransform* toView = renderer->GetActiveCamera()->GetModelViewTransformObject();
  vtkTransform* userTransform = renderer->GetUserLightTransform();
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    Light entry;
    entry.Color = ToVec3(light->GetDiffuseColor()) * light->GetIntensity();
    double focal[3];
    double position[3];
    light->GetTransformedFocalPoint(focal);
    light->GetTransformedPosition(position);
    const glm::dvec3 travel = ToVec3(focal) - ToVec3(position);
    const double length = glm::length(travel);
    entry.WorldPosition = ToVec3(position);
    glm::dvec3 direction = length > 0.0 ? travel / length : glm::dvec3(0.0, 0.0, -1.0);
    entry.WorldDirection = direction;
    toView->TransformNormal(&direction[0], &direction[0]);
    toView->TransformPoint(position, position);
    if (userTransform && !light->LightTypeIsSceneLight())
    {
      userTransform->TransformNormal(&direction[0], &direction[0]);
      userTransform->TransformPoint(position, position);
      vtkLinearTransform* toWorld = toView->GetLinearInverse();
      toWorld->TransformNormal(&direction[0], &entry.WorldDirection[0]);
      toWorld->TransformPoint(position, &entry.WorldPosition[0]);
    }
    entry.Direction = direction;
    entry.Position = ToVec3(position);
    entry.Attenuation = ToVec3(light->GetAttenuationValues());
    entry.ConeAngle = light->GetConeAngle();
    entry.Exponent = light->GetExponent();
    entry.Positional = light->GetPositional() != 0;
    entry.Headlight = light->LightTypeIsHeadlight() != 0;
    entry.FollowsCamera = light->LightTypeIsSceneLight() == 0;
    this->Positional |= entry.Positional;
    ReadShape(light, entry);
    if (entry.Headlight ||
      (entry.Shape > GI_SHAPE_POINT && entry.Positional == (entry.Shape == GI_SHAPE_ANGLE)))
    {
      this->Misshapen += entry.Shape > GI_SHAPE_POINT ? 1 : 0;
      entry.Shape = GI_SHAPE_NONE;
    }
    entry.Side = Transformed(toView, entry.WorldSide);
    entry.Up = Transformed(toView, entry.WorldUp);
    this->Areas |= entry.Shape >= GI_SHAPE_SPHERE;
    this->Shapes |= entry.Shape > GI_SHAPE_POINT;
    this->Entries.push_back(entry);
  }
  // VTK's own decision, which also depends on lights that are off.
  this->SingleHeadlight = this->Entries.size() == 1 && renderer->GetLightingComplexity() == 1;
}

LightTable::Shadowed LightTable::AssignMask(int maximum)
{
  Shadowed shadowed;
  for (std::size_t i = 0; i < this->Entries.size(); ++i)
  {
    if (this->Entries[i].MaskChannel >= 0)
    {
      return {};
    }
    if (!this->Entries[i].Headlight && glm::length(this->Entries[i].Color) > 0.0)
    {
      shadowed.With.push_back(i);
    }
  }
  // Strongest first, because their missing shadows would be most visible.
  std::stable_sort(
    shadowed.With.begin(), shadowed.With.end(), [this](std::size_t a, std::size_t b) {
      return glm::length(this->Entries[a].Color) > glm::length(this->Entries[b].Color);
    });
  const std::size_t count = std::min(shadowed.With.size(), static_cast<std::size_t>(maximum));
  shadowed.Without = static_cast<int>(shadowed.With.size() - count);
  shadowed.With.resize(count);
  for (std::size_t channel = 0; channel < count; ++channel)
  {
    this->Entries[shadowed.With[channel]].MaskChannel = static_cast<int>(channel);
  }
  return shadowed;
}

glm::dvec3 LightTable::TotalColor() const
{
  glm::dvec3 total(0.0);
  for (const auto& light : this->Entries)
  {
    total += light.Color;
  }
  return total;
}

shared::LightData LightTable::MakeData(const Light& light, double scale) const
{
  shared::LightData entry;
  const double cone = light.IsCone() ? std::cos(glm::radians(light.ConeAngle)) : -2.0;
  entry.Color = glm::vec4(light.Color * scale, cone);
  entry.Direction = glm::vec4(light.Direction, light.Exponent);
  entry.Position = glm::vec4(light.Position, 0.0);
  entry.Attenuation = glm::vec4(light.Attenuation, light.Area() / glm::pi<double>());
  entry.Kind = glm::ivec4(this->SingleHeadlight ? GI_LIGHT_HEADLIGHT
      : light.Positional                        ? GI_LIGHT_POSITIONAL
                                                : GI_LIGHT_DIRECTIONAL,
    light.MaskChannel, light.Headlight ? 1 : 0, light.FollowsCamera ? 0 : 1);
  entry.Side = glm::vec4(light.Side, light.Shape);
  const double half = std::sin(light.Size / 2.0);
  entry.Up = glm::vec4(light.Up, light.Shape == GI_SHAPE_ANGLE ? 2.0 * half * half : light.Size);
  return entry;
}

Arguments LightTable::InView(double scale)
{
  this->ViewScale = scale;
  return this->Describe(this->ViewBlock);
}

Arguments LightTable::InWorld(const glm::dvec3& origin)
{
  this->WorldOrigin = origin;
  return this->Describe(this->WorldBlock);
}

Arguments LightTable::Describe(const Buffer& block) const
{
  return Arguments()
    .Block("LightBlock", block)
    .Set("lightCount", static_cast<int>(this->Entries.size()));
}

void LightTable::Upload()
{
  // An empty buffer cannot be bound.
  const std::size_t count = std::max<std::size_t>(this->Entries.size(), 1);
  std::vector<shared::LightData> inView(count);
  std::vector<shared::LightData> inWorld(count);
  for (std::size_t i = 0; i < this->Entries.size(); ++i)
  {
    const Light& light = this->Entries[i];
    inView[i] = this->MakeData(light, this->ViewScale);
    inWorld[i] = this->MakeData(light, 1.0);
    inWorld[i].Direction = glm::vec4(light.WorldDirection, light.Exponent);
    inWorld[i].Position = glm::vec4(light.WorldPosition - this->WorldOrigin, 0.0);
    inWorld[i].Side = glm::vec4(light.WorldSide, inWorld[i].Side.w);
    inWorld[i].Up = glm::vec4(light.WorldUp, inWorld[i].Up.w);
  }
  const std::size_t bytes = count * sizeof(shared::LightData);
  this->ViewBlock.Upload(GL_SHADER_STORAGE_BUFFER, inView.data(), bytes);
  this->WorldBlock.Upload(GL_SHADER_STORAGE_BUFFER, inWorld.data(), bytes);
}
}
