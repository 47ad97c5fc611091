// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "probes/ProbeBalls.h"

#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"

#include <algorithm>

namespace penumbra
{
namespace
{
// Among the passes that modify the picture: over what is lit, before anti-aliasing.
constexpr int ShowOrder = 750;

// Of a cell: at most 0.4 off its place, a baked probe's ball stays in its cell.
constexpr double ShownRadius = 0.09;

void Draw(FrameContext& context, const ProbeBalls& balls, const char* target)
{
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, false);
  scope.DepthMask(false);
  const Program& program = context.Shaders().Fragment(balls.Shader);
  context.BindTarget({ target });
  context.Use(program,
    { context.Input(resource::WindowDepth), context.Input(target), nullptr, nullptr, balls.Light,
      balls.Distance, balls.Probes });
  balls.Set(program);
  SetProbeView(program, context.GetView(), balls.Origin);
  glUniform1f(program.Location("radius"), static_cast<GLfloat>(ShownRadius));
  context.DrawFullscreen();
}
}

void SetProbeView(const Program& program, const View& view, const glm::dvec3& origin)
{
  const glm::mat3 rotation(glm::dmat3(view.ViewToWorld));
  const glm::vec3 eye(glm::dvec3(view.ViewToWorld[3]) - origin);
  glUniformMatrix3fv(program.Location("viewToScene"), 1, GL_FALSE, &rotation[0][0]);
  glUniform3fv(program.Location("eye"), 1, &eye[0]);
}

void AddProbeBalls(FrameBuilder& frame, const std::string& name,
  const std::vector<const char*>& reads, const std::function<ProbeBalls(FrameContext&)>& balls)
{
  const auto add = [&](const std::string& pass) -> PassDeclaration& {
    PassDeclaration& declared = frame.AddPass(pass).Read(resource::WindowDepth);
    for (const char* resource : reads)
    {
      declared.Read(resource);
    }
    return declared;
  };
  add(name).Modify(resource::Color, ShowOrder).Execute([balls](FrameContext& context) {
    Draw(context, balls(context), resource::Color);
  });
  add(name + "-radiance")
    .ModifyIfPresent(resource::Radiance, ShowOrder)
    .Execute([balls](FrameContext& context) { Draw(context, balls(context), resource::Radiance); });
}
}
