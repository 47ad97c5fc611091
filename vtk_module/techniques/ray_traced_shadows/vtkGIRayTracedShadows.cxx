// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIRayTracedShadows.h"

#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"

vtkStandardNewMacro(vtkGIRayTracedShadows);

using namespace penumbra;

vtkGIRayTracedShadows::vtkGIRayTracedShadows() = default;
vtkGIRayTracedShadows::~vtkGIRayTracedShadows() = default;

const char* vtkGIRayTracedShadows::GetOfferedResource()
{
  return resource::DirectVisibility;
}

void vtkGIRayTracedShadows::Contribute(FrameBuilder& frame)
{
  LightTable& lights = frame.Lights();
  const LightTable::Shadowed shadowed = lights.AssignMask(this->MaximumLights);
  if (shadowed.Without > 0)
  {
    frame.AddNote(std::to_string(shadowed.Without) + " of " +
      std::to_string(shadowed.Without + shadowed.With.size()) +
      " lights cast no shadow: raise ray-traced-shadows.maximum-lights for more.");
  }
  if (shadowed.With.empty())
  {
    return;
  }
  RayProps& rays = frame.Rays("they cast no shadow");
  const int layers = (static_cast<int>(shadowed.With.size()) + 3) / 4;
  frame.AddPass("ray-traced-shadows")
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::DepthCopy)
    .Write(resource::DirectVisibility, frame.WindowTexture(GL_RGBA8, layers), "visibility")
    .Write(resource::VisibilityReach, frame.WindowTexture(GL_RGBA16F, layers), "reach")
    .Offer(rays.ShaderArguments())
    .Offer(lights.InWorld(rays.Origin()))
    .Compute("ray_traced_shadows/mask.comp", rays.ShaderDefines(),
      frame.GetView()
        .ToScene(rays.Origin())
        .Set("layerCount", layers)
        .Set("size",
          glm::vec2(std::tan(glm::radians(0.5 * this->LightAngle)), this->LightRadius)),
      Work::Items(frame.GetView().Viewport.z, frame.GetView().Viewport.w));
}
