// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights of a look.
 */
#pragma once

#include "looks/LookDescription.h"

#include "vtkSmartPointer.h"

class vtkLight;
class vtkRenderer;

namespace penumbra
{
class LookLights
{
public:
  /// Add a look's lights to a renderer, which must have no other lights that are on.
  LookLights(const LookDescription& look, vtkRenderer* renderer);

  /// Place the lights that are fixed to the world, once the camera tells which way is up.
  void Place(vtkRenderer* renderer);

  void RemoveFrom(vtkRenderer* renderer) const;

private:
  LookDescription Look;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
};
}
