// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a renderer shows the same picture as before, up to noise: the camera's matrices, the
 * window, and the modification times of everything that is drawn.
 */
#pragma once

#include "graph/View.h"
#include "pass/DarkLamp.h"

#include <vtkType.h>

#include <array>
#include <vector>

class vtkProp;

namespace penumbra
{
class SceneSignature
{
public:
  /// Of a frame about to be drawn, or drawn. techniques: their latest modification time. dark is left out.
  static SceneSignature Of(
    vtkOpenGLRenderer* renderer, const View& view, vtkMTimeType techniques, const DarkLamp& dark);

  /// What differs between two frames.
  SceneChanges ChangesSince(const SceneSignature& before) const;

private:
  enum Group
  {
    Camera,
    Lights,
    Props, ///< all of them: where they are, and how they look
    Looks, ///< shapes and colours, wherever the props are
    Techniques,
    Groups
  };
  void Add(Group group, const double* values, int count);
  void AddProp(vtkProp* prop);

  std::array<std::vector<double>, Groups> Values; ///< times too
};
}
