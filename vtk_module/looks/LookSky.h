// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The sky of a look.
 */
#pragma once

#include "looks/LookDescription.h"

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <array>

class vtkGISkySource;
class vtkRenderer;

namespace penumbra
{
class LookSky
{
public:
  /// Make a look's sky the environment of a renderer, in place of the renderer's own.
  LookSky(const LookDescription& look, vtkRenderer* renderer);

  /// Orient the sky, once there is a camera: let it follow the camera, or stand upright in the world.
  void Place(bool followsCamera, const glm::dvec3& up);

  /// Make the sky the environment again, if another one was set since.
  void Restore(vtkRenderer* renderer) const;

  /// Bring back the renderer's own environment.
  void RemoveFrom(vtkRenderer* renderer) const;

private:
  vtkSmartPointer<vtkGISkySource> Sky;
  std::array<unsigned int, 2>
    Samples{}; ///< of VTK's own textures before, or 0 if they are left alone
};
}
