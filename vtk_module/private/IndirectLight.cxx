// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/IndirectLight.h"

#include "private/Frame.h"
#include "private/ScopedState.h"

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

void ContributeIndirectLight(FrameBuilder& frame, std::vector<IndirectLight> lights)
{
  if (lights.empty())
  {
    return;
  }
  auto& pass = frame.AddPass("indirect-light");
  for (const IndirectLight& light : lights)
  {
    for (const char* resource : light.Reads)
    {
      pass.Read(resource);
    }
  }
  pass.Read(resource::Depth)
    .ReadIfPresent(resource::AmbientVisibility)
    .Write(resource::Irradiance, frame.WindowTexture(GL_RGBA16F))
    .Execute([lights = std::move(lights)](FrameContext& context) {
      // Later passes draw to the framebuffer that was bound before.
      ScopedState outer(context.State());
      context.BindTarget({ resource::Irradiance }, resource::Depth);
      constexpr GLfloat nothing[] = { 0.0f, 0.0f, 0.0f, 0.0f };
      glClearBufferfv(GL_COLOR, 0, nothing);
      for (const IndirectLight& light : lights)
      {
        ScopedState scope(context.State());
        scope.Set(GL_DEPTH_TEST, false);
        scope.DepthMask(false);
        // Over nothing there is nothing to blend with, and blending takes time.
        scope.Set(GL_BLEND, &light != &lights.front());
        context.State()->vtkglBlendFuncSeparate(
          GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
        context.BindTarget({ resource::Irradiance }, resource::Depth);
        light.Draw(context);
      }
    });
}
}
