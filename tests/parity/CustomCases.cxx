// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"
#include "TestData.h"

#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace penumbra_test
{
namespace
{
// Shader code of a user, from shader_code/.
std::string ShaderCode(const std::string& name)
{
  std::ifstream file(TestData("parity/shader_code/" + name + ".glsl"));
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty()) << name;
  return text.str();
}

// The user's code in place of a tag of VTK's fragment shader.
vtkShaderProperty* AddFragmentCode(Stage& stage, const char* tag, const char* name, bool first)
{
  vtkShaderProperty* shader = AddShinyTorus(stage)->GetShaderProperty();
  shader->AddFragmentShaderReplacement(tag, first, ShaderCode(name), false);
  return shader;
}

// Stripes along the object's own coordinates, as in VTK's examples of replaced shaders.
void AddVertexCode(Stage& stage)
{
  vtkShaderProperty* shader = AddShinyTorus(stage)->GetShaderProperty();
  shader->AddVertexShaderReplacement(
    "//VTK::Normal::Dec", true, ShaderCode("vertex_declaration"), false);
  shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true, ShaderCode("vertex"), false);
  shader->AddFragmentShaderReplacement(
    "//VTK::Normal::Dec", true, ShaderCode("stripes_declaration"), false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Impl", true, ShaderCode("stripes"), false);
}
}

ParityCases CustomCases()
{
  return {
    { "shader code on the colour",
      [](Stage& s) { AddFragmentCode(s, "//VTK::Color::Impl", "color", false); } },
    { "shader code on the normal",
      [](Stage& s) { AddFragmentCode(s, "//VTK::Normal::Impl", "normal", true); } },
    { "shader code after the light",
      [](Stage& s) { AddFragmentCode(s, "//VTK::Light::Impl", "after_light", false); }, false },
    { "shader code before the light",
      [](Stage& s) { AddFragmentCode(s, "//VTK::Light::Impl", "before_light", true); } },
    { "shader code that discards",
      [](Stage& s) { AddFragmentCode(s, "//VTK::Light::Impl", "discard", false); } },
    { "shader code with a uniform",
      [](Stage& s) {
        vtkShaderProperty* shader = AddFragmentCode(s, "//VTK::Color::Impl", "uniform", false);
        float tint[3] = { 0.2f, 1.0f, 0.6f };
        shader->GetFragmentCustomUniforms()->SetUniform3f("tint", tint);
      } },
    { "shader code of vertices", AddVertexCode },
    { "shader code of a whole shader",
      [](Stage& s) {
        AddShinyTorus(s)->GetShaderProperty()->SetFragmentShaderCode(ShaderCode("whole").c_str());
      },
      false },
    { "hidden lines removed",
      [](Stage& s) {
        AddShinyTorus(s)->GetProperty()->SetRepresentationToWireframe();
        s.Renderer->UseHiddenLineRemovalOn();
      },
      false },
    { "two-sided lighting off",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Renderer->TwoSidedLightingOff();
      } },
    { "forced opaque, forced translucent",
      [](Stage& s) {
        AddShinyTorus(s)->ForceOpaqueOn();
        s.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(0.4);
        s.Add(Ball())->ForceTranslucentOn();
      } },
  };
}
}
