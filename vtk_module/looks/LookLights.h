// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights of a look.
 */
#pragma once

#include "looks/LookDescription.h"

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

class vtkLight;
class vtkRenderer;

namespace penumbra
{
class LookLights
{
public:
  /// Add a look's lights to a renderer, which must have no other lights that are on.
  LookLights(const LookDescription& look, vtkRenderer* renderer);

  /// Place lights that are fixed to the world around the visible props.
  void Place(vtkRenderer* renderer, const glm::dvec3& up);

  void RemoveFrom(vtkRenderer* renderer) const;

private:
  std::vector<LookLight> Described;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
};
}
