// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lights what VTK draws itself after the opaque props, translucent surfaces and volumes, by what the
 * techniques know of each lamp and of indirect light: changes the mappers' shaders and sets their uniforms.
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

  /// Have mappers build their shaders anew, after the next SetLights().
  void ReloadShaders() { this->Stale = true; }

  /// What lights the props of a frame. Mappers rebuild their shaders when the parts change; throws
  /// std::runtime_error where one that was replaced from a folder is not valid.
  void SetLights(const penumbra::LightTable& lights, penumbra::ForwardLight light);
  /// Nothing does, until SetLights says otherwise.
  void SetNothing() { this->Known = false; }

  /// Take part in the drawing of the state's translucent props and volumes, and no longer.
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

  void SortShadows(const penumbra::LightTable& lights);
  /// The parts of one of VTK's programs, which know where its uniforms are.
  struct Parts
  {
    vtkWeakPointer<vtkShaderProgram> Owner; ///< another program may come to a dead one's address
    GLuint Handle = 0;                      ///< as it was linked last
    std::unique_ptr<penumbra::ForwardProgram> Visibility; ///< nullptr for none
    std::vector<std::unique_ptr<penumbra::ForwardProgram>> Indirect;
  };

  Parts& PartsOf(vtkShaderProgram* program, bool volume);
  void SetShadows(const penumbra::ForwardProgram& part) const;
  void SetParts(vtkShaderProgram* program, bool volume);

  const penumbra::ShaderLibrary* Shaders = nullptr;
  penumbra::ForwardLight Light;    ///< the last that was known
  bool Known = false;              ///< in this frame
  bool Stale = true;               ///< the shaders may differ from those that mappers have
  std::vector<int> ShadowOf;       ///< by light, its place among the shadowed ones or -1
  std::vector<int> ShadowOfSorted; ///< the same, positional lights first
  std::vector<vtkProp*> Props;     ///< that this is attached to
  vtkRenderer* Renderer = nullptr;
  std::vector<int> Units; ///< for the parts' textures
  std::map<vtkShaderProgram*, Parts> Programs;
};
