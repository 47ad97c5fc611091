// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/IndirectLight.h"

#include "gpu/ScopedState.h"
#include "graph/Frame.h"

#include <algorithm>

namespace penumbra
{
Defines OpenDirection(const FrameContext& context, Arguments& arguments)
{
  const Texture* openness = context.Input(resource::AmbientVisibility);
  if (!openness || openness->Desc().Format != GL_RGBA16)
  {
    return {};
  }
  arguments.Sample("openTexture", openness);
  return { { "GI_BENT", "1" } };
}

void ContributeIndirectLight(Frame& frame, std::vector<IndirectLight> lights)
{
  const auto everywhere = std::find_if(lights.begin(), lights.end(),
    [](const IndirectLight& light) { return IsEverywhere(light.Kind); });
  lights.erase(everywhere == lights.end() ? everywhere : everywhere + 1, lights.end());
  if (lights.empty())
  {
    return;
  }
  const bool hasDirectLight = std::any_of(lights.begin(), lights.end(),
    [](const IndirectLight& light) { return light.IncludesDirectLight; });
  for (std::size_t number = 0; number < lights.size(); ++number)
  {
    const IndirectLight& light = lights[number];
    const bool first = number == 0;
    const bool part = IsPartOfLight(light.Kind) && number + 1 < lights.size();
    const int order = static_cast<int>(number);
    auto& pass = frame.AddPass("indirect-light" + (first ? "" : "-" + std::to_string(number + 1)));
    const auto target = [&](const char* name, bool exists) {
      exists ? pass.DrawOver(name, order) : pass.Write(name, frame.WindowTexture(GL_RGBA16F));
    };
    target(resource::Irradiance, !first);
    if (hasDirectLight && (first || light.IncludesDirectLight))
    {
      target(resource::LampLight, !first);
    }
    light.Declare(pass);
    pass.Read(resource::Depth)
      .ReadIfPresent(resource::AmbientVisibility)
      .Execute([light, hasDirectLight, first, part](FrameContext& context) {
        const std::vector<const char*> irradiance = { resource::Irradiance };
        const std::vector<const char*> both = { resource::Irradiance, resource::LampLight };
        ScopedState scope(context.State());
        if (first)
        {
          context.BindTarget(hasDirectLight ? both : irradiance, resource::Depth);
          constexpr GLfloat nothing[] = { 0.0f, 0.0f, 0.0f, 0.0f };
          for (GLint target = 0; target < (hasDirectLight ? 2 : 1); ++target)
          {
            glClearBufferfv(GL_COLOR, target, nothing);
          }
        }
        scope.Set(GL_DEPTH_TEST, false);
        scope.DepthMask(false);
        // The first draw has nothing to blend with, and blending takes time. A part of the light leaves alpha as it is,
        // so that the rest is added.
        scope.Set(GL_BLEND, !first || part);
        context.State()->vtkglBlendFuncSeparate(first ? GL_ONE : GL_ONE_MINUS_DST_ALPHA,
          first ? GL_ZERO : GL_ONE, part ? GL_ZERO : GL_ONE_MINUS_DST_ALPHA, GL_ONE);
        context.BindTarget(light.IncludesDirectLight ? both : irradiance, resource::Depth);
        light.Draw(context);
      });
  }
}
}
