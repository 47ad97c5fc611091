// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The state of a renderer that a look changes, saved before.
 */
#pragma once

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkLight;
class vtkMatrix4x4;
class vtkRenderer;
class vtkTexture;

namespace penumbra
{
class SavedRenderer
{
public:
  explicit SavedRenderer(vtkRenderer* renderer);

  /// Save the background again.
  void SaveBackground(vtkRenderer* renderer);

  /// Switch the saved lights off. Those of a light kit keep their place in the renderer.
  void SwitchLightsOff() const;

  /// Restore the saved lights, which may also be in other renderers.
  void RestoreLights() const;

  /// Restore everything else.
  void Restore(vtkRenderer* renderer) const;

private:
  /// A light, and what changes while the renderer turns lights with the camera.
  struct SavedLight
  {
    vtkSmartPointer<vtkLight> Light;
    int Switch = 1;
    std::array<double, 3> Position;
    std::array<double, 3> FocalPoint;
    vtkSmartPointer<vtkMatrix4x4> Transform;
  };
  struct Background
  {
    std::array<double, 3> Bottom;
    std::array<double, 3> Top;
    double Alpha = 0.0;
    bool Gradient = false;
    bool Textured = false;
    vtkSmartPointer<vtkTexture> Texture;
  };

  std::vector<SavedLight> Lights;
  Background Back;
  bool CreatesLights = true;
  int LightsFollowCamera = 1;
};
}
