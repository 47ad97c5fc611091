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
  RayProps& rays = frame.Rays();
  if (rays.LeftOut() > 0)
  {
    frame.AddNote("rays do not see " + std::to_string(rays.LeftOut()) +
      " props of kinds that cannot be traced yet: they cast no shadow");
  }
  const int layers = (static_cast<int>(shadowed.With.size()) + 3) / 4;
  frame.AddPass("ray-traced-shadows")
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::WindowDepth)
    .Write(resource::DirectVisibility, frame.WindowTexture(GL_RGBA8, layers))
    .Execute([this, &rays, &lights, layers](FrameContext& context) {
      const View& view = context.GetView();
      const Program& program =
        context.Shaders().Compute("ray_traced_shadows/mask.comp", rays.ShaderDefines());
      context.Use(program,
        { context.Input(resource::Albedo), context.Input(resource::Normal),
          context.Input(resource::WindowDepth) });
      rays.Bind(program);
      lights.BindWorld(0, rays.Origin());
      glBindImageTexture(0, context.Output(resource::DirectVisibility)->Get(), 0, GL_TRUE, 0,
        GL_WRITE_ONLY, GL_RGBA8);
      const glm::mat3 rotation(glm::dmat3(view.ViewToWorld));
      const glm::vec3 eye(glm::dvec3(view.ViewToWorld[3]) - rays.Origin());
      glUniformMatrix3fv(program.Location("viewToScene"), 1, GL_FALSE, &rotation[0][0]);
      glUniform3fv(program.Location("eye"), 1, &eye[0]);
      glUniform1i(program.Location("lightCount"), static_cast<GLint>(lights.Lights().size()));
      glUniform1i(program.Location("layerCount"), layers);
      glUniform1i(program.Location("samples"), this->Samples);
      glUniform2f(program.Location("size"),
        static_cast<GLfloat>(std::tan(glm::radians(0.5 * this->LightAngle))),
        static_cast<GLfloat>(this->LightRadius));
      constexpr int group = 8;
      glDispatchCompute(
        (view.Viewport.z + group - 1) / group, (view.Viewport.w + group - 1) / group, 1);
      glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    });
}
