// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs functions of glsl/lib on the GPU, one invocation a row of numbers, to be checked against
// C++.
#pragma once

#include "gpu/ShaderLibrary.h"

#include "vtkHeadlessRenderWindow.h"

#include <glm/glm.hpp>

namespace penumbra_test
{
class ComputeHarness : public testing::Test
{
protected:
  void SetUp() override;
  void TearDown() override;

  /// includes: library files, in order. body: statements that read the vec4 IN(0), IN(1)... of an
  /// invocation and set the vec4 RESULT. inputs: stride vectors for each invocation.
  std::vector<glm::vec4> Run(const std::vector<std::string>& includes, const std::string& body,
    int stride, const std::vector<glm::vec4>& inputs, const penumbra::Defines& defines = {});

  vtkSmartPointer<vtkHeadlessRenderWindow> Window;
  penumbra::ShaderLibrary Library;
};

/// Evenly spread unit vectors, the axes among them.
std::vector<glm::dvec3> UnitVectors(int count);
}
