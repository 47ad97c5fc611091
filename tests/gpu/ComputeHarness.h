// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs functions of glsl/lib on the GPU, for comparison with the same functions in C++.
#pragma once

#include "WindowTest.h"

#include "gpu/ShaderLibrary.h"

#include <glm/glm.hpp>

namespace penumbra_test
{
class ComputeHarness : public WindowTest
{
protected:
  void TearDown() override;

  /// Run one invocation for each stride vectors of inputs, and return their results. includes: library files, in order.
  /// body: statements that read an invocation's vec4 IN(0), IN(1)... and set the vec4 RESULT.
  std::vector<glm::vec4> Run(const std::vector<std::string>& includes, const std::string& body,
    int stride, const std::vector<glm::vec4>& inputs, const penumbra::Defines& defines = {});

  penumbra::ShaderLibrary Library;
};

/// Unit vectors: the six directions along the axes, then count evenly distributed ones.
std::vector<glm::dvec3> UnitVectors(int count);
}
