// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "probes/ProbeBalls.h"

#include "technique/FrameBuilder.h"

namespace penumbra
{
namespace
{
// Order among the passes that modify the picture: after lighting, before anti-aliasing.
constexpr int ShowOrder = 750;

// Radius in cells. A baked probe is at most 0.4 cells off its grid point, so its ball stays in its cell.
constexpr double ShownRadius = 0.09;
}

void AddProbeBalls(FrameBuilder& frame, const std::string& name, const std::string& shader,
  const std::function<void(PassDeclaration&)>& declare)
{
  const auto add = [&](PassDeclaration& pass) {
    pass.Read(resource::DepthCopy);
    declare(pass);
    pass.Draw(shader, {}, Arguments().Set("radius", ShownRadius));
  };
  add(frame.AddPass(name).Modify(resource::Color, ShowOrder, "before"));
  add(frame.AddPass(name + "-radiance").ModifyIfPresent(resource::Radiance, ShowOrder, "before"));
}
}
