// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The one place that substitutes into VTK's shader templates: what a mapper is about to light is
 * written to the G-buffer instead. The inserted text itself lives in glsl/capture/.
 */
#pragma once

#include "vtkOpenGLRenderPass.h"

#include <string>

namespace penumbra
{
class MaterialTable;
class ShaderLibrary;
}

class vtkGICaptureHooks : public vtkOpenGLRenderPass
{
public:
  static vtkGICaptureHooks* New();
  vtkTypeMacro(vtkGICaptureHooks, vtkOpenGLRenderPass);

  void SetTables(penumbra::MaterialTable* materials, const penumbra::ShaderLibrary* shaders);

  /// Whether to write the G-buffer's extended set (textures, PBR), and the reflected surroundings
  /// apart. Mappers rebuild their shaders when this changes.
  void SetExtended(bool extended, bool surroundings);

  /// Have mappers build their shaders anew.
  void Renew();

  /// Compile the snippets by themselves. Throws std::runtime_error with the compiler's message where
  /// one that was replaced from a folder is not valid.
  void CheckSnippets() const;

  /// The kind of projection of the draws that follow, whatever the active camera's is.
  void SetParallel(bool parallel) { this->Parallel = parallel; }

  /// Put this pass on the props' list of passes, and take it off.
  void Attach(const vtkRenderState* state) { this->PreRender(state); }
  void Detach(const vtkRenderState* state) { this->PostRender(state); }

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->StageTime; }

protected:
  vtkGICaptureHooks() = default;
  ~vtkGICaptureHooks() override = default;

private:
  vtkGICaptureHooks(const vtkGICaptureHooks&) = delete;
  void operator=(const vtkGICaptureHooks&) = delete;

  std::string Snippet(const char* name) const;

  penumbra::MaterialTable* Materials = nullptr;
  const penumbra::ShaderLibrary* Shaders = nullptr;
  bool Extended = false;
  bool Surroundings = false;
  bool Parallel = false;
  vtkMTimeType StageTime = 1;
};
