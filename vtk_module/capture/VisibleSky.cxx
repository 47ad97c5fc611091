// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/VisibleSky.h"

#include "gpu/ScopedState.h"
#include "graph/Frame.h"
#include "rays/TexturePixels.h"

#include "vtkOpenGLRenderer.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"

namespace penumbra
{
namespace
{
// Whether the skybox's shader writes values encoded for display: by its own gamma correction, or from images of eight
// bits that nothing decodes. VTK's image-based lighting treats these as encoded too.
bool IsEncoded(vtkSkybox* sky)
{
  return sky->GetGammaCorrect() || (sky->GetTexture() && HoldsDisplayValues(sky->GetTexture()));
}
}

bool IsSky(vtkProp* prop)
{
  auto* sky = vtkSkybox::SafeDownCast(prop);
  return sky && sky->GetProjection() != vtkSkybox::Floor && sky->GetTexture() &&
    !sky->HasTranslucentPolygonalGeometry();
}

int DrawSkies(vtkOpenGLRenderer* renderer, const std::vector<vtkProp*>& skies)
{
  int drawn = 0;
  for (vtkProp* sky : skies)
  {
    drawn += sky->RenderOpaqueGeometry(renderer);
  }
  return drawn;
}

void ContributeSky(Frame& frame, const std::vector<vtkProp*>& skies)
{
  if (skies.empty())
  {
    return;
  }
  // The last skybox hides the others.
  auto* sky = static_cast<vtkSkybox*>(skies.back());
  frame.AddPass("sky")
    .Write(resource::Sky, frame.WindowTexture(GL_RGBA32F))
    .Execute([sky](FrameContext& context) {
      ScopedState scope(context.State());
      context.BindTarget({ resource::Sky });
      const GLfloat nothing[] = { 0.0f, 0.0f, 0.0f, IsEncoded(sky) ? 1.0f : 0.0f };
      glClearBufferfv(GL_COLOR, 0, nothing);
      scope.Set(GL_BLEND, false);
      scope.Set(GL_DEPTH_TEST, false);
      context.State()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
      sky->RenderOpaqueGeometry(context.Renderer());
    });
}
}
