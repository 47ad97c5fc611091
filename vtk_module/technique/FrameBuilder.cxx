// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "technique/FrameBuilder.h"

#include "capture/MotionTable.h"
#include "capture/SceneCapture.h"
#include "rays/RayProps.h"

#include "vtkOpenGLRenderer.h"
#include "vtkTexture.h"

#include <glm/gtc/matrix_transform.hpp>

namespace penumbra
{
RayProps& FrameBuilder::Rays(const std::string& consequence)
{
  if (!this->TracedSceneReady)
  {
    this->TracedScene.Update(this->GetRenderer(), this->RayParts);
    this->TracedSceneReady = true;
    if (this->TracedScene.WithoutNormals() > 0)
    {
      this->AddNote("points of " + std::to_string(this->TracedScene.WithoutNormals()) +
        " surfaces have normals that are zero or no numbers: they are lit by the normals of their "
        "cells");
    }
  }
  if (this->TracedScene.LeftOut() > 0)
  {
    this->AddNote("rays do not see " + std::to_string(this->TracedScene.LeftOut()) +
      " props of kinds that cannot be traced yet: " + consequence);
  }
  return this->TracedScene;
}

MotionTable& FrameBuilder::Motion()
{
  if (!this->MotionReady)
  {
    this->Motions.Begin(this->CurrentView);
    this->Scene.SetMotion(&this->Motions);
    this->MotionReady = true;
  }
  return this->Motions;
}

void FrameBuilder::RequestLitRadiance()
{
  this->LitRadianceRequested = true;
  this->RequestSurroundings();
}

void FrameBuilder::AddIndirectLight(IndirectLight light)
{
  const auto position = std::upper_bound(this->Indirect.begin(), this->Indirect.end(), light,
    [](const IndirectLight& a, const IndirectLight& b) { return a.Kind < b.Kind; });
  this->Indirect.insert(position, std::move(light));
  this->RequestSurroundings();
}

const LightField* FrameBuilder::FindLightField() const
{
  const auto found = std::find_if(this->Indirect.begin(), this->Indirect.end(),
    [](const IndirectLight& light) { return static_cast<bool>(light.Field.Declare); });
  return found == this->Indirect.end() ? nullptr : &found->Field;
}

ForwardLight FrameBuilder::GetForwardLight() const
{
  ForwardLight light;
  light.Visibility = this->Visibility;
  light.Display = this->Display;
  light.Rules = this->CurrentPlan.Rules();
  for (const IndirectLight& indirect : this->Indirect)
  {
    if (!indirect.Forward.IsEmpty())
    {
      light.Indirect.push_back(indirect.Forward);
    }
  }
  if (this->CurrentPlan.SpreadShare() > 0.0)
  {
    light.Spread(this->CurrentPlan.SpreadShare(), this->CurrentLights.TotalColor());
  }
  return light;
}

void FrameBuilder::RequestSurroundings()
{
  // Only PBR materials are lit by the environment, and they need the extended set of targets.
  if (this->GetRenderer()->GetUseImageBasedLighting() &&
    this->GetRenderer()->GetEnvironmentTexture() && this->Scene.IsExtended())
  {
    this->Scene.Request(resource::Surroundings);
  }
}

void FrameBuilder::AddLastPasses()
{
  for (const auto& [technique, addPasses] : this->Last)
  {
    this->AddFor(technique, {});
    addPasses(*this);
  }
  this->AddFor({}, {});
}

void FrameBuilder::AddSurface(
  const std::array<double, 6>& bounds, double near, double far, const RayPart* part)
{
  if (part)
  {
    this->RayParts.push_back(*part);
  }
  View& view = this->CurrentView;
  view.SurfaceBounds = bounds;
  glm::dmat4& m = view.ViewToClip;
  const auto clip = [&m](double distance) {
    return (m[3][2] - m[2][2] * distance) / (m[3][3] - m[2][3] * distance);
  };
  const double nearest = std::min(-1.0, clip(near));
  const double farthest = std::max(1.0, clip(far));
  if (nearest == -1.0 && farthest == 1.0)
  {
    return;
  }
  // In both kinds of projection, another range of distances is a scale and a shift of depths.
  const double scale = 2.0 / (farthest - nearest);
  const double shift = -1.0 - scale * nearest;
  for (int column = 0; column < 4; ++column)
  {
    m[column][2] = scale * m[column][2] + shift * m[column][3];
  }
  view.DepthWindow = scale * view.DepthWindow + 0.5 * (1.0 + shift - scale);
}

int FrameBuilder::AveragedFrames() const
{
  const bool linear = this->CurrentPlan.HasLitParts() || !this->Scene.HasPBR();
  return linear ? this->FramesInPicture : 0;
}

void FrameBuilder::SetJitter(const glm::dvec2& pixels)
{
  View& view = this->CurrentView;
  const glm::dvec2 size(view.Viewport.z, view.Viewport.w);
  const glm::dvec3 shift(2.0 * (pixels - view.Jitter) / size, 0.0);
  view.ViewToClip = glm::translate(glm::dmat4(1.0), shift) * view.ViewToClip;
  view.Jitter = pixels;
}
}
