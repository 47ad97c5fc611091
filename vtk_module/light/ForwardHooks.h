// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Adds the techniques' visibility and indirect light to what VTK draws itself after the opaque props, which are
 * translucent surfaces and volumes: changes the mappers' shaders and sets their uniforms.
 */
#pragma once

#include "capture/ShaderHooks.h"
#include "light/ForwardPart.h"

#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <vector>

class vtkRenderer;

namespace penumbra
{
class LightTable;
}

class vtkGIForwardHooks : public vtkGIShaderHooks
{
public:
  static vtkGIForwardHooks* New();
  vtkTypeMacro(vtkGIForwardHooks, vtkGIShaderHooks);

  void SetShaders(const penumbra::ShaderLibrary* shaders) { this->Shaders = shaders; }

  /// Have mappers rebuild their shaders after the next SetLights().
  void ReloadShaders() { this->ShadersOutdated = true; }

  /// Set the light of a frame. Mappers rebuild their shaders if the parts differ from the last ones. Throws
  /// std::runtime_error if a shader that was replaced from a folder is not valid.
  void SetLights(const penumbra::LightTable& lights, penumbra::ForwardLight light);
  /// Leave props as VTK lights them, until the next SetLights().
  void ClearLights() { this->HasLight = false; }

  /// Attach to the state's translucent props and volumes, and detach again.
  void Attach(const vtkRenderState* state);
  void Detach();

protected:
  vtkGIForwardHooks() { this->ActiveDrawBuffers = 1; }
  ~vtkGIForwardHooks() override = default;

  void BeforeMapper(
    const penumbra::ShaderTexts& texts, vtkAbstractMapper* mapper, vtkProp* prop) override;
  void AfterMapper(const penumbra::ShaderTexts& texts, vtkProp* prop) override;
  void SetUniforms(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop) override;

private:
  vtkGIForwardHooks(const vtkGIForwardHooks&) = delete;
  void operator=(const vtkGIForwardHooks&) = delete;

  void UpdateShadowChannels(const penumbra::LightTable& lights);
  /// The parts in one of VTK's programs, with the locations of their uniforms.
  struct ProgramParts
  {
    vtkWeakPointer<vtkShaderProgram> Owner; ///< tells a new program at the address of a deleted one
    GLuint Handle = 0;                      ///< changes if the program is linked again
    std::unique_ptr<penumbra::ForwardProgram> Visibility; ///< nullptr if there is none
    std::unique_ptr<penumbra::ForwardProgram> Display;    ///< nullptr if there is none
    std::vector<std::unique_ptr<penumbra::ForwardProgram>> Indirect;
  };

  ProgramParts& PartsOfProgram(vtkShaderProgram* program, bool volume);
  void SetRules(vtkShaderProgram* program, vtkProp* prop) const;
  void SetShadows(const penumbra::ForwardProgram& part) const;
  void SetParts(vtkShaderProgram* program, vtkProp* prop);

  const penumbra::ShaderLibrary* Shaders = nullptr;
  penumbra::ForwardLight Light;          ///< the last light that was not empty
  bool HasLight = false;                 ///< whether this frame has light
  bool ShadersOutdated = true;           ///< the mappers' shaders may be outdated
  std::vector<int> ShadowChannels;       ///< mask channel of each light, or -1
  std::vector<int> SortedShadowChannels; ///< the same, positional lights first
  std::vector<vtkProp*> Props;           ///< props that the hooks are attached to
  vtkRenderer* Renderer = nullptr;
  std::vector<int> Units; ///< for the parts' textures
  std::map<vtkShaderProgram*, ProgramParts> Programs;
};
