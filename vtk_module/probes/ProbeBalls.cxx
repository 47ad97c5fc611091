// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "probes/ProbeBalls.h"

#include "technique/FrameBuilder.h"

namespace penumbra
{
namespace
{
// Among the passes that modify the picture: over what is lit, before anti-aliasing.
constexpr int ShowOrder = 750;

// Of a cell: at most 0.4 off its place, a baked probe's ball stays in its cell.
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
