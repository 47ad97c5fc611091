// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/IndirectLight.h"

#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "graph/Frame.h"
#include "light/LightTable.h"

#include <algorithm>

namespace penumbra
{
OpenDirection::OpenDirection(const FrameContext& context)
{
  const Texture* openness = context.Input(resource::AmbientVisibility);
  if (openness && openness->Desc().Format == GL_RGBA16)
  {
    this->Map = openness;
    this->Variant["GI_BENT"] = "1";
  }
}

void ContributeIndirectLight(
  Frame& frame, const LightTable& lamps, SceneCapture& capture, std::vector<IndirectLight> lights)
{
  if (lights.empty())
  {
    return;
  }
  const bool knowsLamps = std::any_of(
    lights.begin(), lights.end(), [](const IndirectLight& light) { return light.KnowsLamps; });
  auto& pass = frame.AddPass("indirect-light");
  // What the capture leaves needs neither a target of its own, nor clearing and reading that.
  // Without lights VTK shows colours as they are.
  const bool started =
    !lamps.Lights().empty() && capture.StartForAmbient(resource::Irradiance);
  if (started)
  {
    pass.DrawOver(resource::Irradiance, 0);
  }
  else
  {
    pass.Write(resource::Irradiance, frame.WindowTexture(GL_RGBA16F));
  }
  if (knowsLamps)
  {
    pass.Write(resource::LampLight, frame.WindowTexture(GL_RGBA16F));
  }
  for (const IndirectLight& light : lights)
  {
    for (const char* resource : light.Reads)
    {
      pass.Read(resource);
    }
  }
  pass.Read(resource::Depth)
    .ReadIfPresent(resource::AmbientVisibility)
    .Execute([lights = std::move(lights), knowsLamps, started](FrameContext& context) {
      const std::vector<const char*> irradiance = { resource::Irradiance };
      const std::vector<const char*> both = { resource::Irradiance, resource::LampLight };
      // Later passes draw to the framebuffer that was bound before.
      ScopedState outer(context.State());
      context.BindTarget(knowsLamps ? both : irradiance, resource::Depth);
      constexpr GLfloat nothing[] = { 0.0f, 0.0f, 0.0f, 0.0f };
      for (GLint target = started ? 1 : 0; target < (knowsLamps ? 2 : 1); ++target)
      {
        glClearBufferfv(GL_COLOR, target, nothing);
      }
      for (const IndirectLight& light : lights)
      {
        ScopedState scope(context.State());
        scope.Set(GL_DEPTH_TEST, false);
        scope.DepthMask(false);
        // Over nothing there is nothing to blend with, and blending takes time.
        scope.Set(GL_BLEND, &light != &lights.front());
        context.State()->vtkglBlendFuncSeparate(
          GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
        context.BindTarget(light.KnowsLamps ? both : irradiance, resource::Depth);
        light.Draw(context);
      }
    });
}
}
