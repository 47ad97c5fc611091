// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether a renderer shows the same picture as before, up to noise: the camera's matrices, the
 * window, and the modification times of everything that is drawn.
 */
#pragma once

#include "private/Frame.h"

#include <vtkType.h>

class vtkProp;

namespace penumbra
{
class SceneSignature
{
public:
  /// Of a frame about to be drawn. techniques: their latest modification time.
  static SceneSignature Of(vtkOpenGLRenderer* renderer, const View& view, vtkMTimeType techniques);

  /// When what a prop draws changed last: it, its data, tables, textures, and those of its parts.
  static vtkMTimeType TimeOf(vtkProp* prop);

  bool operator==(const SceneSignature& other) const
  {
    return this->Numbers == other.Numbers && this->Times == other.Times;
  }

private:
  std::vector<double> Numbers;
  std::vector<vtkMTimeType> Times;
};
}
