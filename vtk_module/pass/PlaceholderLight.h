// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A lamp that gives no light, for renderers without any lamp that is on: there VTK shows colours as they are, and what
 * surfaces and environments give off could light nothing.
 */
#pragma once

#include "vtkNew.h"

class vtkLight;
class vtkOpenGLRenderer;

namespace penumbra
{
class DarkLamp
{
public:
  DarkLamp();
  ~DarkLamp();
  DarkLamp(const DarkLamp&) = delete;
  DarkLamp& operator=(const DarkLamp&) = delete;

  /// What is drawn from now on is lit, if by nothing.
  void Add(vtkOpenGLRenderer* renderer);
  /// Leave the renderer as it was.
  void Remove();
  /// Whether this is the lamp, which is none of the scene's.
  bool Is(const vtkLight* lamp) const { return lamp == this->Lamp.Get(); }

private:
  vtkNew<vtkLight> Lamp;
  vtkOpenGLRenderer* Renderer = nullptr; ///< that has it
};
}
