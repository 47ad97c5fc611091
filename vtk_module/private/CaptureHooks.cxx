// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/CaptureHooks.h"

#include "private/MaterialTable.h"
#include "private/ShaderLibrary.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkGICaptureHooks);

namespace
{
// VTK's template is filled in the order Color, Edges, Normal, Light, TCoord; a texture multiplies
// the lit colour at TCoord. So the capture stands behind TCoord.
const char* const Marker = "//PENUMBRA::Capture";

bool Contains(const std::string& text, const char* what)
{
  return text.find(what) != std::string::npos;
}
}

void vtkGICaptureHooks::SetTables(
  penumbra::MaterialTable* materials, const penumbra::ShaderLibrary* shaders)
{
  this->Materials = materials;
  this->Shaders = shaders;
}

void vtkGICaptureHooks::SetExtended(bool extended, bool surroundings)
{
  if (this->Extended != extended || this->Surroundings != surroundings)
  {
    this->Extended = extended;
    this->Surroundings = surroundings;
    this->Renew();
  }
}

void vtkGICaptureHooks::Renew()
{
  this->Modified();
  this->StageTime = this->GetMTime();
}

std::string vtkGICaptureHooks::Snippet(const char* name) const
{
  penumbra::Defines defines;
  if (this->Extended)
  {
    defines["GI_EXTENDED"] = "1";
  }
  if (this->Surroundings)
  {
    defines["GI_SURROUNDINGS"] = "1";
  }
  return this->Shaders->Source(std::string("capture/") + name, defines);
}

void vtkGICaptureHooks::CheckSnippets() const
{
  for (const char* name : { "phong.glsl", "pbr.glsl", "as_drawn.glsl" })
  {
    std::string text = this->Shaders->Source("capture/check.frag");
    vtkShaderProgram::Substitute(text, Marker, this->Snippet(name), false);
    // As VTK does with its outputs.
    std::string outputs;
    for (int i = 0; i < 6; ++i)
    {
      const std::string number = std::to_string(i);
      vtkShaderProgram::Substitute(text, "gl_FragData[" + number + "]", "fragOutput" + number);
      outputs += "out vec4 fragOutput" + number + ";\n";
    }
    text.insert(text.find('\n', text.find("#version")) + 1, outputs);
    this->Shaders->Check(std::string("capture/") + name, GL_FRAGMENT_SHADER, text);
  }
}

bool vtkGICaptureHooks::PreReplaceShaderValues(std::string&, std::string&,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Output::Dec",
    "//VTK::Output::Dec\n" + this->Snippet("declarations.glsl"), false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::TCoord::Impl",
    this->Snippet("before_texture.glsl") + "//VTK::TCoord::Impl\n" + Marker + "\n", false);
  return true;
}

bool vtkGICaptureHooks::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  // Mappers take the kind of projection from the camera object, after the hook that sets uniforms;
  // a shadow map's view may be of the other kind, so the shaders ask a uniform of ours.
  for (std::string* source : { &vertexShader, &geometryShader, &fragmentShader })
  {
    vtkShaderProgram::Substitute(*source, "cameraParallel", "giParallel");
  }
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  const bool unlit = !Contains(fragmentShader, "normalVCVSOutput") ||
    Contains(fragmentShader, "vec4(ambientColor + diffuseColor, opacity)");
  const bool pbr = Contains(fragmentShader, "roughnessUniform");
  const bool layered =
    Contains(fragmentShader, "#define ANISOTROPY") || Contains(fragmentShader, "#define CLEAR_COAT");
  const std::string direct = "  color += Lo;\n";
  const char* snippet = "as_drawn.glsl";
  if (!unlit && pbr && !layered && actor && Contains(fragmentShader, direct.c_str()))
  {
    // What VTK adds before direct light is the light from all around.
    vtkShaderProgram::Substitute(
      fragmentShader, direct, "  vec3 giSurrounding = color;\n" + direct, false);
    snippet = "pbr.glsl";
  }
  else if (!unlit && !pbr && actor)
  {
    snippet = "phong.glsl";
  }
  vtkShaderProgram::Substitute(fragmentShader, Marker, this->Snippet(snippet), false);
  return true;
}

bool vtkGICaptureHooks::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (program->IsUniformUsed("giParallel"))
  {
    program->SetUniformi("giParallel", this->Parallel ? 1 : 0);
  }
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  if (actor && program->IsUniformUsed("giMaterial"))
  {
    const int front = this->Materials->Find(actor->GetProperty());
    program->SetUniformi("giMaterial", front);
    if (program->IsUniformUsed("giBackMaterial"))
    {
      vtkProperty* back = actor->GetBackfaceProperty();
      program->SetUniformi("giBackMaterial", back ? this->Materials->Find(back) : front);
    }
  }
  return true;
}
