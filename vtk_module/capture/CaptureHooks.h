// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The one place that substitutes into VTK's shader templates: what a mapper is about to light is
 * written to the G-buffer instead. The inserted text itself lives in glsl/capture/.
 */
#pragma once

#include "capture/CaptureOutputs.h"
#include "capture/ShaderHooks.h"

#include <glm/glm.hpp>

#include <string>

class vtkActor;
class vtkOpenGLRenderer;

namespace penumbra
{
class MaterialTable;
class MotionTable;
class ShaderLibrary;
}

class vtkGICaptureHooks : public vtkGIShaderHooks
{
public:
  static vtkGICaptureHooks* New();
  vtkTypeMacro(vtkGICaptureHooks, vtkGIShaderHooks);

  void SetTables(penumbra::MaterialTable* materials, const penumbra::ShaderLibrary* shaders);

  /// Which targets to write. Mappers rebuild their shaders when this changes.
  void SetOutputs(const penumbra::CaptureOutputs& outputs);

  /// Compile the snippets by themselves. Throws std::runtime_error with the compiler's message where
  /// one that was replaced from a folder is not valid.
  void CheckSnippets() const;

  /// The kind of projection of the draws that follow, whatever the active camera's is.
  void SetParallel(bool parallel) { this->Parallel = parallel; }

  /// Whether the draws that follow are of casters' depths; the texel in which the pattern starts that
  /// casters are thinned out by where they cover in part (see glsl/capture/coverage.glsl).
  void SetCasting(bool casting, const glm::ivec2& anchor);

  /// Which of the props is drawn next.
  void SetLayer(int layer) { this->Layer = layer; }

  /// Whether what has no usable normal is captured with its flat pieces' own, or as VTK draws it.
  void SetMendsNormals(bool mends) { this->MendsNormals = mends; }

  /// Have the motion of what is drawn recorded; nullptr: nobody asks.
  void SetMotion(penumbra::MotionTable* motion) { this->Motion = motion; }

  /// A texture unit that nobody else uses while props are drawn, and the view they are drawn in.
  void SetTextureUnit(int unit, vtkOpenGLRenderer* renderer);

  /// Put this pass on the props' list of passes, and take it off.
  void Attach(const vtkRenderState* state) { this->PreRender(state); }
  void Detach(const vtkRenderState* state) { this->PostRender(state); }

protected:
  vtkGICaptureHooks() = default;
  ~vtkGICaptureHooks() override = default;

  void BeforeMapper(
    const penumbra::ShaderTexts& texts, vtkAbstractMapper* mapper, vtkProp* prop) override;
  void AfterMapper(const penumbra::ShaderTexts& texts, vtkProp* prop) override;
  void SetUniforms(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop) override;

private:
  void SetDisplacement(vtkShaderProgram* program, vtkActor* actor);

  vtkGICaptureHooks(const vtkGICaptureHooks&) = delete;
  void operator=(const vtkGICaptureHooks&) = delete;

  std::string Snippet(const char* name, const penumbra::CaptureOutputs& outputs,
    penumbra::Defines variant = {}) const;

  penumbra::MaterialTable* Materials = nullptr;
  penumbra::MotionTable* Motion = nullptr;
  int TextureUnit = 0;
  vtkOpenGLRenderer* Renderer = nullptr; ///< of the draws that follow
  const penumbra::ShaderLibrary* Shaders = nullptr;
  penumbra::CaptureOutputs Outputs;
  bool Parallel = false;
  bool Casting = false;
  glm::ivec2 Anchor{ 0 };
  int Layer = 0;
  bool MendsNormals = false;
};
