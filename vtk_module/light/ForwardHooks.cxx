// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/ForwardHooks.h"

#include "light/ForwardShaders.h"
#include "light/LightTable.h"

#include "forward.h"

#include "vtkCamera.h"
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

vtkStandardNewMacro(vtkGIForwardHooks);

using namespace penumbra;

namespace
{
bool IsVolume(vtkProp* prop)
{
  return vtkVolume::SafeDownCast(prop) != nullptr;
}

vtkOpenGLRenderWindow* WindowOf(vtkRenderer* renderer)
{
  return static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
}

int TexturesOf(const ForwardLight& light)
{
  int count = light.Visibility.Textures;
  for (const ForwardPart& part : light.Indirect)
  {
    count += part.Textures;
  }
  return count;
}
}

void vtkGIForwardHooks::SetLights(const LightTable& lights, ForwardLight light)
{
  light.Indirect.resize(std::min(light.Indirect.size(), ForwardShaders::MostParts));
  this->Known = false;
  if (light.IsEmpty())
  {
    return;
  }
  if (this->Stale || !light.HasShadersOf(this->Light))
  {
    this->Stale = true;
    // VTK ends the program where a shader does not compile.
    if (!this->Shaders->OverrideFolder().empty())
    {
      ForwardShaders(*this->Shaders, light).Check();
    }
    this->RebuildShaders();
    this->Programs.clear();
    this->Stale = false;
  }
  this->Light = std::move(light);
  this->Known = true;
  this->SortShadows(lights);
}

void vtkGIForwardHooks::SortShadows(const LightTable& lights)
{
  this->ShadowOf.clear();
  this->ShadowOfSorted.clear();
  std::vector<int> others;
  for (const auto& light : lights.Lights())
  {
    this->ShadowOf.push_back(light.MaskChannel);
    (light.Positional ? this->ShadowOfSorted : others).push_back(light.MaskChannel);
  }
  this->ShadowOfSorted.insert(this->ShadowOfSorted.end(), others.begin(), others.end());
  this->ShadowOf.resize(std::min(this->ShadowOf.size(), std::size_t(GI_FORWARD_LIGHTS)));
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
  for (int i = TexturesOf(this->Light); i > 0; --i)
  {
    this->Units.push_back(WindowOf(this->Renderer)->GetTextureUnitManager()->Allocate());
  }
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
  for (const int unit : this->Units)
  {
    WindowOf(this->Renderer)->GetTextureUnitManager()->Free(unit);
  }
  this->Units.clear();
  this->Props.clear();
}

void vtkGIForwardHooks::BeforeMapper(const ShaderTexts& texts, vtkAbstractMapper*, vtkProp* prop)
{
  if (IsVolume(prop))
  {
    ForwardShaders::MarkVolume(texts.Fragment);
  }
  else
  {
    ForwardShaders::MarkSurface(texts.Fragment);
  }
}

void vtkGIForwardHooks::AfterMapper(const ShaderTexts& texts, vtkProp* prop)
{
  const ForwardShaders shaders(*this->Shaders, this->Light);
  if (IsVolume(prop))
  {
    shaders.LightVolume(texts.Fragment);
  }
  else
  {
    shaders.LightSurface(texts);
  }
}

vtkGIForwardHooks::Parts& vtkGIForwardHooks::PartsOf(vtkShaderProgram* program, bool volume)
{
  const auto handle = static_cast<GLuint>(program->GetHandle());
  Parts& parts = this->Programs[program];
  if (parts.Owner == program && parts.Handle == handle)
  {
    return parts;
  }
  parts = Parts();
  parts.Owner = program;
  parts.Handle = handle;
  if (program->IsUniformUsed("giLights"))
  {
    parts.Visibility = std::make_unique<ForwardProgram>(handle, "", volume);
  }
  const std::string spread = ForwardProgram::FieldName(0) + "Spread";
  if (program->IsUniformUsed("giParallelRays") || program->IsUniformUsed(spread.c_str()))
  {
    for (std::size_t i = 0; i < this->Light.Indirect.size(); ++i)
    {
      parts.Indirect.push_back(
        std::make_unique<ForwardProgram>(handle, ForwardProgram::FieldName(i), volume));
    }
  }
  return parts;
}

void vtkGIForwardHooks::SetShadows(const ForwardProgram& part) const
{
  part.SetValues(Arguments()
                   .Set("giLights", static_cast<int>(this->ShadowOf.size()))
                   .Set("giKept", this->Light.Kept)
                   .Set("giShadowOf", this->ShadowOf)
                   .Set("giShadowOfSorted", this->ShadowOfSorted));
}

void vtkGIForwardHooks::SetParts(vtkShaderProgram* program, bool volume)
{
  const Parts& parts = this->PartsOf(program, volume);
  vtkOpenGLState* state = WindowOf(this->Renderer)->GetState();
  const int* units = this->Units.data();
  if (parts.Visibility)
  {
    this->SetShadows(*parts.Visibility);
    parts.Visibility->Begin(state, units);
    this->Light.Visibility.Bind(*parts.Visibility);
  }
  units += this->Light.Visibility.Textures;
  for (std::size_t i = 0; i < parts.Indirect.size(); ++i)
  {
    const ForwardPart& light = this->Light.Indirect[i];
    parts.Indirect[i]->SetValues(Arguments().Set(
      "giParallelRays", this->Renderer->GetActiveCamera()->GetParallelProjection() != 0));
    parts.Indirect[i]->Begin(state, units);
    light.Bind(*parts.Indirect[i]);
    units += light.Textures;
  }
}

void vtkGIForwardHooks::SetUniforms(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (auto* volume = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    // VTK's mapper leaves the viewport alone where it has a pass; where it draws a smaller picture of
    // its own, that is not what it wants.
    const float reduction = volume->GetImageSampleDistance();
    if (reduction != 1.0f)
    {
      int size[2];
      this->Renderer->GetTiledSize(&size[0], &size[1]);
      WindowOf(this->Renderer)
        ->GetState()
        ->vtkglViewport(0, 0, static_cast<GLsizei>(size[0] / reduction),
          static_cast<GLsizei>(size[1] / reduction));
    }
  }
  this->SetParts(program, IsVolume(prop));
}
