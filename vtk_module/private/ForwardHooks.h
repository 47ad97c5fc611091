// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lights what VTK draws itself after the opaque props, translucent surfaces and volumes, by what the
 * techniques know of each light: the one place that substitutes into VTK's templates for them. The
 * inserted text itself lives in glsl/forward/.
 */
#pragma once

#include "private/ForwardVisibility.h"

#include "vtkOpenGLRenderPass.h"

#include <vector>

class vtkOpenGLRenderer;
class vtkProp;
class vtkRenderState;
class vtkRenderer;

namespace penumbra
{
class LightTable;
}

class vtkGIForwardHooks : public vtkOpenGLRenderPass
{
public:
  static vtkGIForwardHooks* New();
  vtkTypeMacro(vtkGIForwardHooks, vtkOpenGLRenderPass);

  void SetShaders(const penumbra::ShaderLibrary* shaders) { this->Shaders = shaders; }

  /// Have mappers build their shaders anew; throws std::runtime_error where one that was replaced from a
  /// folder is not valid.
  void ReloadShaders();

  /// What lights the props of a frame. Mappers rebuild their shaders when the parts change.
  void SetLights(const penumbra::LightTable& lights, penumbra::ForwardVisibility visibility);
  /// Nothing does, until SetLights says otherwise.
  void SetNothing() { this->Known = false; }

  /// Take part in the drawing of the state's translucent props and volumes, and no longer.
  void Attach(const vtkRenderState* state);
  void Detach();

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->StageTime; }

protected:
  vtkGIForwardHooks() { this->ActiveDrawBuffers = 1; }
  ~vtkGIForwardHooks() override = default;

private:
  vtkGIForwardHooks(const vtkGIForwardHooks&) = delete;
  void operator=(const vtkGIForwardHooks&) = delete;

  void Declare(std::string& fragmentShader, penumbra::Defines variant) const;

  const penumbra::ShaderLibrary* Shaders = nullptr;
  penumbra::ForwardVisibility Visibility; ///< the last that was known
  bool Known = false;                     ///< in this frame
  std::vector<int> ShadowOf;       ///< by light, its place among the shadowed ones or -1
  std::vector<int> ShadowOfSorted; ///< the same, positional lights first
  std::vector<vtkProp*> Props;     ///< that this is attached to
  vtkRenderer* Renderer = nullptr;
  int TextureUnit = -1;
  vtkMTimeType StageTime = 1;
};
