// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The textures that VTK keeps bound while a render pass runs, as it does those of image-based light. Its mappers read
 * them from the units that they were activated on, without binding them again. Passes of our own bind to fixed units,
 * so these are put back before VTK draws.
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
  /// Note what is bound to the units that VTK has given away.
  void Record(vtkOpenGLRenderWindow* window);

  /// Bind that again.
  void Restore(vtkOpenGLState* state) const;

  /// Bind that, and nothing else on units that VTK has not given away since. A texture of ours that stayed bound would
  /// pass for one of VTK's in the next frame, which may delete it before it is put back.
  void LeaveNoOthers(vtkOpenGLRenderWindow* window) const;

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
