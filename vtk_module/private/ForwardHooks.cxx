// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/ForwardHooks.h"

#include "private/LightTable.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"
#include "vtkVolume.h"

#include <algorithm>
#include <regex>

vtkStandardNewMacro(vtkGIForwardHooks);

namespace
{
// As many as glsl/forward/lights.glsl has room for; lights beyond are without shadow.
constexpr std::size_t MostLights = 64;
const char* const DeclareHere = "//PENUMBRA::ForwardDec";
const char* const ShadeHere = "//PENUMBRA::ForwardImpl";

bool Contains(const std::string& text, const char* what)
{
  return text.find(what) != std::string::npos;
}

void Substitute(std::string& text, const std::string& what, const std::string& by)
{
  vtkShaderProgram::Substitute(text, what, by);
}

bool IsVolume(vtkProp* prop)
{
  return vtkVolume::SafeDownCast(prop) != nullptr;
}

// Where a volume's shader begins to add up what its lights give, npos where it has no lights.
std::size_t LightLoop(const std::string& text)
{
  std::size_t loop = std::string::npos;
  const std::size_t lighting = text.find("vec4 computeLighting(");
  for (const char* head : { "for (int posNum", "for (int dirNum", "for (int lightNum" })
  {
    loop = std::min(loop, text.find(head, lighting));
  }
  return lighting == std::string::npos || !Contains(text, "g_dataPos") ? std::string::npos : loop;
}
}

void vtkGIForwardHooks::ReloadShaders()
{
  const std::string name = "forward/check.frag";
  this->Shaders->Check(name, GL_FRAGMENT_SHADER, this->Shaders->Source(name));
  this->Modified();
  this->StageTime = this->GetMTime();
}

void vtkGIForwardHooks::SetLights(
  const penumbra::LightTable& lights, penumbra::ForwardVisibility visibility)
{
  this->Known = !visibility.Source.empty();
  if (!this->Known)
  {
    return;
  }
  if (visibility.Source != this->Visibility.Source ||
    visibility.OnSurfaces != this->Visibility.OnSurfaces ||
    visibility.InVolumes != this->Visibility.InVolumes)
  {
    this->Modified();
    this->StageTime = this->GetMTime();
  }
  this->Visibility = std::move(visibility);
  this->ShadowOf.clear();
  this->ShadowOfSorted.clear();
  std::vector<int> others;
  for (const auto& light : lights.Lights())
  {
    this->ShadowOf.push_back(light.MaskChannel);
    (light.Positional ? this->ShadowOfSorted : others).push_back(light.MaskChannel);
  }
  this->ShadowOfSorted.insert(this->ShadowOfSorted.end(), others.begin(), others.end());
  this->ShadowOf.resize(std::min(this->ShadowOf.size(), MostLights));
  this->ShadowOfSorted.resize(this->ShadowOf.size());
}

void vtkGIForwardHooks::Attach(const vtkRenderState* state)
{
  this->Props.clear();
  this->Renderer = state->GetRenderer();
  if (!this->Known)
  {
    return;
  }
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    if (IsVolume(prop) || prop->HasTranslucentPolygonalGeometry())
    {
      this->Props.push_back(prop);
    }
  }
  if (this->Props.empty())
  {
    return;
  }
  vtkRenderState some(this->Renderer);
  some.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
  this->PreRender(&some);
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  this->TextureUnit = window->GetTextureUnitManager()->Allocate();
}

void vtkGIForwardHooks::Detach()
{
  if (this->Props.empty())
  {
    return;
  }
  vtkRenderState some(this->Renderer);
  some.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
  this->PostRender(&some);
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  window->GetTextureUnitManager()->Free(this->TextureUnit);
  this->Props.clear();
}

bool vtkGIForwardHooks::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (IsVolume(prop))
  {
    const std::string tag = "//VTK::ComputeLighting::Dec";
    Substitute(fragmentShader, tag, std::string(DeclareHere) + "\n" + tag);
    return true;
  }
  Substitute(fragmentShader, "//VTK::Light::Dec", std::string("//VTK::Light::Dec\n") + DeclareHere);
  Substitute(fragmentShader, "//VTK::Light::Impl", std::string(ShadeHere) + "\n//VTK::Light::Impl");
  return true;
}

void vtkGIForwardHooks::Declare(std::string& fragmentShader, penumbra::Defines variant) const
{
  Substitute(fragmentShader, "//VTK::System::Dec", this->Shaders->Source("forward/head.glsl"));
  Substitute(fragmentShader, DeclareHere,
    this->Shaders->Source(this->Visibility.Source, variant) +
      this->Shaders->Source("forward/lights.glsl"));
}

bool vtkGIForwardHooks::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (IsVolume(prop))
  {
    const std::size_t loop = LightLoop(fragmentShader);
    if (loop == std::string::npos)
    {
      return true;
    }
    penumbra::Defines variant = this->Visibility.InVolumes;
    if (Contains(fragmentShader, "posNum") || Contains(fragmentShader, "dirNum"))
    {
      variant["GI_POSITIONAL_FIRST"] = "1";
    }
    // The sample's place in view coordinates, by the names that different versions have for it.
    const char* place = Contains(fragmentShader, "g_texToView")
      ? "g_texToView"
      : "in_modelViewMatrix * in_volumeMatrix[0] * in_textureDatasetMatrix[0]";
    fragmentShader.insert(
      loop, std::string("giArriveAt(") + place + " * vec4(g_dataPos, 1.0));\n  ");
    fragmentShader = std::regex_replace(fragmentShader,
      std::regex("in_light(Diffuse|Specular)Color\\[(posNum|dirNum|lightNum)\\]"),
      "giArrives[$2] * $&");
    this->Declare(fragmentShader, variant);
    return true;
  }
  const bool lit = Contains(fragmentShader, "lightColor0") &&
    Contains(fragmentShader, "vertexVC") && Contains(fragmentShader, "normalVCVSOutput") &&
    Contains(fragmentShader, ShadeHere) && Contains(fragmentShader, DeclareHere);
  if (!lit)
  {
    return true;
  }
  Substitute(fragmentShader, ShadeHere, this->Shaders->Source("forward/surface.glsl"));
  fragmentShader = std::regex_replace(
    fragmentShader, std::regex("uniform vec3 lightColor"), "uniform vec3 giColor");
  fragmentShader = std::regex_replace(
    fragmentShader, std::regex("\\blightColor([0-9]+)\\b"), "(giArrives[$1] * lightColor$1)");
  fragmentShader = std::regex_replace(
    fragmentShader, std::regex("uniform vec3 giColor"), "uniform vec3 lightColor");
  this->Declare(fragmentShader, this->Visibility.OnSurfaces);
  return true;
}

bool vtkGIForwardHooks::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  if (auto* volume = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    // VTK's mapper leaves the viewport alone where it has a pass; where it draws a smaller picture of
    // its own, that is not what it wants.
    const float reduction = volume->GetImageSampleDistance();
    if (reduction != 1.0f)
    {
      int size[2];
      this->Renderer->GetTiledSize(&size[0], &size[1]);
      window->GetState()->vtkglViewport(
        0, 0, static_cast<GLsizei>(size[0] / reduction), static_cast<GLsizei>(size[1] / reduction));
    }
  }
  if (!program->IsUniformUsed("giLights"))
  {
    return true;
  }
  const int count = static_cast<int>(this->ShadowOf.size());
  program->SetUniformi("giLights", count);
  if (program->IsUniformUsed("giShadowOf"))
  {
    program->SetUniform1iv("giShadowOf", count, this->ShadowOf.data());
  }
  if (program->IsUniformUsed("giShadowOfSorted"))
  {
    program->SetUniform1iv("giShadowOfSorted", count, this->ShadowOfSorted.data());
  }
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->TextureUnit));
  this->Visibility.Bind(program, this->TextureUnit, IsVolume(prop));
  return true;
}
