// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL state set through VTK's cache and restored when the scope ends.
 */
#pragma once

#include "gpu/GL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

namespace penumbra
{
/// Refresh VTK's cache with no buffers and no program bound. VTK restores those that were bound when the cache was last
/// filled, although they may have been deleted since, together with their props.
inline void RefreshState(vtkOpenGLRenderWindow* window)
{
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  window->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(0);
  window->GetState()->Reset();
}

class ScopedState
{
public:
  explicit ScopedState(vtkOpenGLState* state)
    : State(state)
  {
    state->Push();
  }
  ~ScopedState() { this->State->Pop(); }
  ScopedState(const ScopedState&) = delete;
  ScopedState& operator=(const ScopedState&) = delete;

  void Set(GLenum capability, bool on)
  {
    on ? this->State->vtkglEnable(capability) : this->State->vtkglDisable(capability);
  }
  void DepthMask(bool on) { this->State->vtkglDepthMask(on ? GL_TRUE : GL_FALSE); }
  void DepthFunc(GLenum function) { this->State->vtkglDepthFunc(function); }
  void ColorMask(bool on)
  {
    const GLboolean value = on ? GL_TRUE : GL_FALSE;
    this->State->vtkglColorMask(value, value, value, value);
  }
  void Viewport(int x, int y, int width, int height)
  {
    this->State->vtkglViewport(x, y, width, height);
    this->State->vtkglScissor(x, y, width, height);
  }

private:
  vtkOpenGLState* State;
};
}
