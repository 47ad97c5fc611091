// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rasters props into the G-buffer or a shadow map by their own mappers, and knows which props can
 * take part: the rest is drawn by VTK as it stands.
 */
#pragma once

#include "capture/CaptureOutputs.h"
#include "capture/MaterialTable.h"

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <vector>

class vtkGICaptureHooks;
class vtkOpenGLRenderer;
class vtkProp;
class vtkRenderState;

namespace penumbra
{
class Frame;
class FrameContext;
class MotionTable;
class ShaderLibrary;

class SceneCapture
{
public:
  SceneCapture(const ShaderLibrary& shaders);
  ~SceneCapture();

  /// The shaders come from another folder: check those that VTK will compile, and have mappers take
  /// them. Throws std::runtime_error where one is not valid.
  void ReloadShaders();

  /// Sort the props of a frame: those in view that can be captured, those that VTK must draw, and
  /// all visible ones, in view or not, that may cast shadows.
  void Collect(const vtkRenderState* state);

  /// Record the motion of what is drawn, in this frame.
  void SetMotion(MotionTable* motion);

  /// Whether points' normals that are zero or no numbers count as none, in this frame. VTK draws them black.
  void SetMendsNormals(bool mends);

  /// Have an optional resource written in this frame. Ask while techniques contribute.
  void Request(const char* resource) { this->Outputs.Request(resource); }

  /// Whether the highlight of any prop in view reflects this share of the incoming light or more.
  bool Reflects(double share) const;

  /// Where no prop in view has an ambient term, have its target start another resource: rgb and a of 0 where something
  /// was captured, anything elsewhere. False where some may have one: nothing is changed.
  bool StartForAmbient(const char* resource);

  /// Whether any caster may cover what lies behind it in part.
  bool CastsInPart() const;

  /// Add the pass that writes the G-buffer.
  void Contribute(Frame& frame);

  /// Draw every caster's depth as seen with these matrices into the bound framebuffer; of what covers
  /// in part, as many texels, by a pattern that starts in one of them.
  void DrawCasters(vtkOpenGLRenderer* renderer, const glm::dmat4& worldToView,
    const glm::dmat4& viewToClip, bool parallel, const glm::ivec2& anchor);

  /// Opaque geometry of the props that could not be captured, by VTK into its own framebuffer.
  int DrawOthers(vtkOpenGLRenderer* renderer);

  /// Skyboxes behind everything, which are none of the others: see VisibleSky.h.
  const std::vector<vtkProp*>& Skies() const { return this->Behind; }

  const std::vector<vtkProp*>& Casters() const { return this->All; }
  MaterialTable& Materials() { return this->Table; }
  bool IsExtended() const { return this->Outputs.Extended; }
  int CapturedProps() const { return this->Drawn; }

private:
  bool MayHaveAmbient() const;
  void Draw(FrameContext& context);
  /// Draw the props' opaque geometry by the hooks, and the translucent where asked for.
  int DrawProps(vtkOpenGLRenderer* renderer, std::vector<vtkProp*>& props, bool translucent);

  vtkSmartPointer<vtkGICaptureHooks> Hooks;
  MaterialTable Table;
  std::vector<vtkProp*> Captured;
  std::vector<vtkProp*> Others;
  std::vector<vtkProp*> Behind;
  std::vector<vtkProp*> All;
  CaptureOutputs Outputs;
  MotionTable* Motion = nullptr; ///< of this frame's view, where anybody asks
  bool Environment = false;      ///< images light physically based materials
  int Drawn = 0;
};
}
