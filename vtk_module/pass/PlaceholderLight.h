// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A light of intensity 0 for renderers in which no light is on. Without any light VTK draws unlit colours, and emission
 * and environments could not light anything.
 */
#pragma once

#include "vtkNew.h"

class vtkLight;
class vtkOpenGLRenderer;

namespace penumbra
{
class PlaceholderLight
{
public:
  PlaceholderLight();
  ~PlaceholderLight();
  PlaceholderLight(const PlaceholderLight&) = delete;
  PlaceholderLight& operator=(const PlaceholderLight&) = delete;

  /// Add the light to a renderer, unless another one is on.
  void Add(vtkOpenGLRenderer* renderer);
  /// Remove the light from the renderer.
  void Remove();
  /// Whether a light is this one, which is not part of the scene.
  bool Is(const vtkLight* light) const { return light == this->Light.Get(); }

private:
  vtkNew<vtkLight> Light;
  vtkOpenGLRenderer* Renderer = nullptr; ///< the renderer that has the light, or nullptr
};
}
