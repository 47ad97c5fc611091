// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

namespace penumbra_test
{
namespace
{
vtkActor* AddTorus(Stage& stage)
{
  vtkActor* actor = stage.Add(Torus());
  actor->GetProperty()->SetSpecular(0.5);
  actor->GetProperty()->SetSpecularPower(20.0);
  Stage::LookAround(stage.Renderer);
  return actor;
}

// The user's code in place of a tag of VTK's fragment shader.
vtkShaderProperty* AddFragmentCode(Stage& stage, const char* tag, const char* code, bool first)
{
  vtkShaderProperty* shader = AddTorus(stage)->GetShaderProperty();
  shader->AddFragmentShaderReplacement(tag, first, code, false);
  return shader;
}

// Stripes along the object's own coordinates, as in VTK's examples of replaced shaders.
void AddVertexCode(Stage& stage)
{
  vtkShaderProperty* shader = AddTorus(stage)->GetShaderProperty();
  shader->AddVertexShaderReplacement(
    "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\nout vec4 myPosition;\n", false);
  shader->AddVertexShaderReplacement(
    "//VTK::Normal::Impl", true, "//VTK::Normal::Impl\n  myPosition = vertexMC;\n", false);
  shader->AddFragmentShaderReplacement(
    "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\nin vec4 myPosition;\n", false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Impl", true,
    "//VTK::Normal::Impl\n  diffuseColor *= 0.5 + 0.5 * sin(40.0 * myPosition.x);\n", false);
}
}

ParityCases CustomCases()
{
  return {
    { "shader code on the colour",
      [](Stage& s) {
        AddFragmentCode(s, "//VTK::Color::Impl",
          "//VTK::Color::Impl\n  diffuseColor = diffuseColor.bgr;\n", false);
      } },
    { "shader code on the normal",
      [](Stage& s) {
        AddFragmentCode(s, "//VTK::Normal::Impl",
          "//VTK::Normal::Impl\n  normalVCVSOutput = normalize(normalVCVSOutput + vec3(0.3, 0.0, "
          "0.0));\n",
          true);
      } },
    { "shader code after the light",
      [](Stage& s) {
        AddFragmentCode(s, "//VTK::Light::Impl",
          "//VTK::Light::Impl\n  gl_FragData[0].rgb = floor(gl_FragData[0].rgb * 4.0) / 4.0;\n",
          false);
      },
      false },
    { "shader code before the light",
      [](Stage& s) {
        AddFragmentCode(s, "//VTK::Light::Impl",
          "  ambientColor = vec3(0.2, 0.0, 0.1);\n//VTK::Light::Impl\n", true);
      } },
    { "shader code that discards",
      [](Stage& s) {
        AddFragmentCode(s, "//VTK::Light::Impl",
          "//VTK::Light::Impl\n  if (mod(gl_FragCoord.x, 8.0) < 3.0) { discard; }\n", false);
      } },
    { "shader code with a uniform",
      [](Stage& s) {
        vtkShaderProperty* shader = AddFragmentCode(
          s, "//VTK::Color::Impl", "//VTK::Color::Impl\n  diffuseColor *= tint;\n", false);
        float tint[3] = { 0.2f, 1.0f, 0.6f };
        shader->GetFragmentCustomUniforms()->SetUniform3f("tint", tint);
      } },
    { "shader code of vertices", AddVertexCode },
    { "shader of one's own",
      [](Stage& s) {
        AddTorus(s)->GetShaderProperty()->SetFragmentShaderCode(
          "//VTK::System::Dec\n//VTK::Output::Dec\nin vec4 vertexVCVSOutput;\n"
          "in vec3 normalVCVSOutput;\nvoid main()\n{\n"
          "  gl_FragData[0] = vec4(abs(normalVCVSOutput), 1.0);\n}\n");
      },
      false },
    { "hidden lines removed",
      [](Stage& s) {
        AddTorus(s)->GetProperty()->SetRepresentationToWireframe();
        s.Renderer->UseHiddenLineRemovalOn();
      },
      false },
    { "two-sided lighting off",
      [](Stage& s) {
        AddTorus(s);
        s.Renderer->TwoSidedLightingOff();
      } },
    { "opaque by force, translucent by force",
      [](Stage& s) {
        AddTorus(s)->ForceOpaqueOn();
        s.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(0.4);
        s.Add(Ball())->ForceTranslucentOn();
      } },
  };
}
}
