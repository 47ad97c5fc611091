// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures that VTK keeps bound while a render pass runs, such as those of image-based light. Its mappers read
 * them from the units on which they were activated, without binding them again. Our own passes bind to fixed units,
 * so VTK's textures are restored before VTK draws.
 */
#pragma once

#include "gpu/GL.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

namespace penumbra
{
class HeldTextures
{
public:
  /// Record the textures on the units that VTK has allocated.
  void Record(vtkOpenGLRenderWindow* window);

  /// Bind the recorded textures again.
  void Restore(vtkOpenGLState* state) const;

  /// Bind the recorded textures again and unbind all others, except on units that VTK has allocated since. If one of
  /// our textures stayed bound, it would be recorded as VTK's in the next frame, and might be deleted before it is
  /// restored.
  void UnbindOthers(vtkOpenGLRenderWindow* window) const;

private:
  struct Binding
  {
    GLenum Unit;
    GLenum Target;
    GLuint Name;
  };
  std::vector<Binding> Bindings;
};
}
