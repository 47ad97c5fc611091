// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tells whether a renderer shows the same picture as before, up to noise. Consists of the camera's matrices, the
 * viewport, and the modification times of everything that is drawn but overlays.
 */
#pragma once

#include "graph/View.h"
#include "pass/PlaceholderLight.h"

#include <vtkType.h>

#include <array>
#include <vector>

class vtkLight;
class vtkProp;

namespace penumbra
{
class SceneSignature
{
public:
  /// The signature of a frame, before or after it is drawn. techniques: their latest modification time. placeholder is
  /// left out.
  static SceneSignature Of(vtkOpenGLRenderer* renderer, const View& view, vtkMTimeType techniques,
    const PlaceholderLight& placeholder);

  /// What differs between two frames.
  SceneChanges ChangesSince(const SceneSignature& before) const;

private:
  enum Group
  {
    Camera,
    Lights,
    CarriedLights, ///< lights that follow the camera
    Props,         ///< positions and appearance of all props
    Presence,      ///< which props are visible
    Looks,         ///< appearance of all props: shapes and colours
    Techniques,
    Groups
  };
  void Add(Group group, const double* values, int count);
  void AddLight(vtkLight* light);
  void AddProp(vtkProp* prop);

  std::array<std::vector<double>, Groups> Values; ///< include modification times
};
}
