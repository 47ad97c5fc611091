// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/ForwardHooks.h"

#include "capture/PropTraits.h"
#include "light/ForwardShaders.h"
#include "light/LightTable.h"

#include "forward.h"

#include "vtkActor.h"
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

int CountTextures(const ForwardLight& light)
{
  int count = light.Visibility.Textures + light.Display.Textures;
  for (const ForwardPart& part : light.Indirect)
  {
    count += part.Textures;
  }
  return count;
}
}

void vtkGIForwardHooks::SetLights(const LightTable& lights, ForwardLight light)
{
  light.Indirect.resize(std::min(light.Indirect.size(), ForwardShaders::MaximumParts));
  this->HasLight = false;
  if (light.IsEmpty())
  {
    return;
  }
  if (this->ShadersOutdated || !light.HasShadersOf(this->Light))
  {
    this->ShadersOutdated = true;
    // VTK exits the process if a shader does not compile.
    if (!this->Shaders->OverrideFolder().empty())
    {
      ForwardShaders(*this->Shaders, light).Check();
    }
    this->RebuildShaders();
    this->Programs.clear();
    this->ShadersOutdated = false;
  }
  this->Light = std::move(light);
  this->HasLight = true;
  this->UpdateShadowChannels(lights);
}

void vtkGIForwardHooks::UpdateShadowChannels(const LightTable& lights)
{
  this->ShadowChannels.clear();
  this->SortedShadowChannels.clear();
  std::vector<int> others;
  for (const auto& light : lights.Lights())
  {
    this->ShadowChannels.push_back(light.MaskChannel);
    (light.Positional ? this->SortedShadowChannels : others).push_back(light.MaskChannel);
  }
  this->SortedShadowChannels.insert(this->SortedShadowChannels.end(), others.begin(), others.end());
  this->ShadowChannels.resize(
    std::min(this->ShadowChannels.size(), std::size_t(GI_FORWARD_LIGHTS)));
  this->SortedShadowChannels.resize(this->ShadowChannels.size());
}

void vtkGIForwardHooks::Attach(const vtkRenderState* state)
{
  this->Props.clear();
  this->Renderer = state->GetRenderer();
  if (!this->HasLight)
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
  vtkRenderState attached(this->Renderer);
  attached.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
  this->PreRender(&attached);
  for (int i = CountTextures(this->Light); i > 0; --i)
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
  vtkRenderState attached(this->Renderer);
  attached.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
  this->PostRender(&attached);
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

vtkGIForwardHooks::ProgramParts& vtkGIForwardHooks::PartsOfProgram(
  vtkShaderProgram* program, bool volume)
{
  const auto handle = static_cast<GLuint>(program->GetHandle());
  ProgramParts& parts = this->Programs[program];
  if (parts.Owner == program && parts.Handle == handle)
  {
    return parts;
  }
  parts = ProgramParts();
  parts.Owner = program;
  parts.Handle = handle;
  if (program->IsUniformUsed("giLights"))
  {
    parts.Visibility = std::make_unique<ForwardProgram>(handle, "", volume);
  }
  if (program->IsUniformUsed("giMapsTones"))
  {
    parts.Display = std::make_unique<ForwardProgram>(handle, "", volume);
  }
  const ForwardProgram whole(handle, "", volume);
  const std::string first = ForwardProgram::FieldName(0);
  if (std::any_of(whole.Inputs().begin(), whole.Inputs().end(),
        [&first](const Program::Input& input) { return input.Name.rfind(first, 0) == 0; }))
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
                   .Set("giLights", static_cast<int>(this->ShadowChannels.size()))
                   .Set("giKept", this->Light.DirectScale)
                   .Set("giShadowOf", this->ShadowChannels)
                   .Set("giShadowOfSorted", this->SortedShadowChannels));
}

// Set the rules of reflection for a prop. giAbsorbed is 0 in programs of mappers that set no uniforms.
void vtkGIForwardHooks::SetRules(vtkShaderProgram* program, vtkProp* prop) const
{
  const SurfaceRules& rules = this->Light.Rules;
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool data = rules.ChangesData() && (!actor || IsColoredByData(actor));
  const auto set = [program](const char* name, auto value) {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformf(name, static_cast<float>(value));
    }
  };
  set("giAbsorbed", 1.0 - rules.Reflectance);
  set("giDataFloor", data ? rules.DataFloor : 0.0);
  for (const auto& [name, on] : { std::pair("giDataKeepsHue", data && rules.DataKeepsHue),
         std::pair("giCompensates", rules.Compensates) })
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformi(name, on ? 1 : 0);
    }
  }
}

void vtkGIForwardHooks::SetParts(vtkShaderProgram* program, vtkProp* prop)
{
  const ProgramParts& parts = this->PartsOfProgram(program, IsVolume(prop));
  vtkOpenGLState* state = WindowOf(this->Renderer)->GetState();
  const int* units = this->Units.data();
  if (parts.Visibility)
  {
    this->SetShadows(*parts.Visibility);
    parts.Visibility->Begin(state, units);
    this->Light.Visibility.Bind(*parts.Visibility);
  }
  units += this->Light.Visibility.Textures;
  if (parts.Display)
  {
    parts.Display->Begin(state, units);
    this->Light.Display.Bind(*parts.Display);
  }
  units += this->Light.Display.Textures;
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
    // VTK's mapper does not set the viewport if a render pass is active, although it needs another one if it
    // draws a smaller picture of its own.
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
  if (this->Light.HasRules())
  {
    this->SetRules(program, prop);
  }
  this->SetParts(program, prop);
}
