// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rasterizes props into the G-buffer or a shadow map with their own mappers. Props that cannot be captured
 * are drawn by VTK as usual.
 */
#pragma once

#include "capture/CaptureOutputs.h"
#include "capture/MaterialTable.h"
#include "graph/FrameGraph.h"

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
struct SurfaceRules;

class SceneCapture
{
public:
  SceneCapture(const ShaderLibrary& shaders);
  ~SceneCapture();

  /// Use shaders from another folder: check those that VTK will compile, and have mappers rebuild
  /// theirs. Throws std::runtime_error if one is not valid.
  void ReloadShaders();

  /// Sort the props of a frame: those in view that can be captured, those that VTK must draw, and
  /// all visible ones, in view or not, that may cast shadows.
  void Collect(const vtkRenderState* state);

  /// Set the table that records the motion of props in this frame; nullptr for none.
  void SetMotion(MotionTable* motion);

  /// Set whether point normals that are zero or NaN count as missing in this frame. VTK draws them black.
  void SetMendsNormals(bool mends);

  /// Set the rules by which the surfaces of this frame reflect.
  void SetRules(const SurfaceRules& rules);

  /// Request an optional resource in this frame, while techniques contribute.
  void Request(const char* resource) { this->Outputs.Request(resource); }

  /// Whether the highlight of any prop in view reflects at least this share of the incoming light.
  bool Reflects(double share) const;

  /// Whether some prop in view may have an ambient term.
  bool MayHaveAmbient() const { return this->HasAmbient; }

  /// Whether any occluder may cover pixels only partly.
  bool CastsPartialShadows() const;

  /// Have a surface that is no prop drawn into the G-buffer after the props, where it is in front of them. Its fragment
  /// shader can read the depth before it as depthTexture. Its outputs are those of capture/declarations.glsl, with the
  /// same macros. VTK's own depth buffer must not be drawn to then.
  void AddSurface(const Shape& shape, const std::string& shader, const Arguments& arguments)
  {
    this->Surfaces.push_back({ shape, shader, arguments });
  }
  bool HasSurfaces() const { return !this->Surfaces.empty(); }

  /// Add the pass that writes the G-buffer. hasLights: whether any light is on.
  void Contribute(Frame& frame, bool hasLights);

  /// Draw the depth of all occluders, as seen with these matrices, into the bound framebuffer. Occluders with partial
  /// coverage are drawn in a corresponding share of the texels, by a pattern that starts at anchor.
  void DrawCasters(vtkOpenGLRenderer* renderer, const glm::dmat4& worldToView,
    const glm::dmat4& viewToClip, bool parallel, const glm::ivec2& anchor);

  /// Have VTK draw the opaque geometry of the props that cannot be captured into its own framebuffer. Returns the
  /// number of props drawn.
  int DrawOthers(vtkOpenGLRenderer* renderer);

  /// Skyboxes behind everything, which DrawOthers() does not draw: see VisibleSky.h.
  const std::vector<vtkProp*>& Skies() const { return this->SkyProps; }

  const std::vector<vtkProp*>& Casters() const { return this->CasterProps; }
  MaterialTable& Materials() { return this->Table; }
  bool IsExtended() const { return this->Outputs.Extended; }
  /// Whether some prop in view is a PBR material.
  bool HasPBR() const;
  int CapturedProps() const { return this->CapturedPropCount; }

private:
  struct Surface
  {
    Shape Outline;
    std::string Shader;
    Arguments Given;
  };
  void Draw(FrameContext& context);
  void DrawSurfaces(FrameContext& context);
  /// Draw the props' opaque geometry with the hooks, and optionally the translucent geometry.
  int DrawProps(vtkOpenGLRenderer* renderer, std::vector<vtkProp*>& props, bool translucent);

  vtkSmartPointer<vtkGICaptureHooks> Hooks;
  MaterialTable Table;
  std::vector<vtkProp*> Captured;
  std::vector<vtkProp*> Others;
  std::vector<vtkProp*> SkyProps;
  std::vector<vtkProp*> CasterProps;
  std::vector<Surface> Surfaces;
  CaptureOutputs Outputs;
  MotionTable* Motion = nullptr; ///< of this frame's view, if motion is requested
  bool HasEnvironment = false;   ///< whether images light PBR materials
  bool HasAmbient = false;
  int CapturedPropCount = 0;
};
}
