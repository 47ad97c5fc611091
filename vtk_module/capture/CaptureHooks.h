// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The only place that substitutes into VTK's shader templates for the capture: the inputs of the lighting are
 * written to the G-buffer instead of being lit. The inserted text is in glsl/capture/.
 */
#pragma once

#include "capture/CaptureOutputs.h"
#include "capture/ShaderHooks.h"
#include "rays/SurfaceRules.h"

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

  /// Set the targets to write. Mappers rebuild their shaders when this changes.
  void SetOutputs(const penumbra::CaptureOutputs& outputs);

  /// Compile the snippets by themselves. Throws std::runtime_error with the compiler's message if
  /// one that was replaced from a folder is not valid.
  void CheckSnippets() const;

  /// Set the kind of projection of the following draws, regardless of the active camera's.
  void SetParallel(bool parallel) { this->Parallel = parallel; }

  /// Set the window depths outside of which nothing is drawn, see View::DepthWindow.
  void SetDepthWindow(const glm::vec2& window) { this->DepthWindow = window; }

  /// Set whether the following draws write the depth of occluders to a shadow map. anchor: texel in which the pattern
  /// of thresholds for partial coverage starts (see glsl/capture/coverage.glsl).
  void SetCasting(bool casting, const glm::ivec2& anchor);

  /// Set the index of the prop that is drawn next.
  void SetLayer(int layer) { this->Layer = layer; }

  /// Set whether surfaces without usable normals are captured with the normals of their facets, or as VTK draws them.
  void SetMendsNormals(bool mends) { this->MendsNormals = mends; }

  /// Set the rules by which surfaces reflect.
  void SetRules(const penumbra::SurfaceRules& rules) { this->Rules = rules; }

  /// Set the table that records the motion of props; nullptr for none.
  void SetMotion(penumbra::MotionTable* motion) { this->Motion = motion; }

  /// Set a texture unit that nobody else uses while props are drawn, and the renderer that draws them.
  void SetTextureUnit(int unit, vtkOpenGLRenderer* renderer);

  /// Add this pass to the props' list of passes, and remove it.
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
  vtkOpenGLRenderer* Renderer = nullptr; ///< of the following draws
  const penumbra::ShaderLibrary* Shaders = nullptr;
  penumbra::CaptureOutputs Outputs;
  bool Parallel = false;
  glm::vec2 DepthWindow{ 0.0f, 1.0f };
  bool Casting = false;
  glm::ivec2 Anchor{ 0 };
  int Layer = 0;
  bool MendsNormals = false;
  penumbra::SurfaceRules Rules;
};
