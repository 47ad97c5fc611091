// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/Vertical.h"

#include "base/Matrices.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

namespace penumbra
{
glm::dvec3 UpOf(const LookDescription& look, vtkRenderer* renderer)
{
  if (look.Up)
  {
    return ToVec3(look.Up->data());
  }
  const glm::dvec3 viewUp = ToVec3(renderer->GetActiveCamera()->GetViewUp());
  glm::dvec3 axis(0.0);
  int largest = 0;
  for (int i = 1; i < 3; ++i)
  {
    largest = std::abs(viewUp[i]) > std::abs(viewUp[largest]) ? i : largest;
  }
  axis[largest] = viewUp[largest] < 0.0 ? -1.0 : 1.0;
  return axis;
}

glm::dvec3 FrontOf(const glm::dvec3& up)
{
  return up.y != 0.0 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, -1.0, 0.0);
}
}
