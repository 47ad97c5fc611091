// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws VTK props with other matrices than the active camera's, without changing the camera.
 * Mappers take their matrices from vtkOpenGLCamera's cache, which this fills and restores. Thus no
 * event is sent, no modification time changes, and no shader is rebuilt.
 */
#pragma once

#include <glm/glm.hpp>

class vtkOpenGLCamera;
class vtkOpenGLRenderer;

namespace penumbra
{
class CameraOverride
{
public:
  CameraOverride(
    vtkOpenGLRenderer* renderer, const glm::dmat4& worldToView, const glm::dmat4& viewToClip);
  ~CameraOverride();
  CameraOverride(const CameraOverride&) = delete;
  CameraOverride& operator=(const CameraOverride&) = delete;

  /// The matrices that mappers currently use.
  static glm::dmat4 WorldToView(vtkOpenGLRenderer* renderer);
  static glm::dmat4 ViewToClip(vtkOpenGLRenderer* renderer);

private:
  void Store(const glm::dmat4& worldToView, const glm::dmat4& viewToClip);

  vtkOpenGLRenderer* Renderer;
  glm::dmat4 SavedWorldToView;
  glm::dmat4 SavedViewToClip;
};
}
