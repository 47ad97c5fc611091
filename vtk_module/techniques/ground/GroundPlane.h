// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A ground: a horizontal disc below the visible props.
 */
#pragma once

#include "gpu/Arguments.h"
#include "rays/RayPart.h"

#include <glm/glm.hpp>

class vtkRenderer;

namespace penumbra
{
struct View;

/// The axis nearest to a direction.
glm::dvec3 NearestAxis(const glm::dvec3& direction);

struct GroundPlane
{
  glm::dvec3 Up{ 0.0, 0.0, 1.0 };
  glm::dvec3 Middle{ 0.0 };
  double Radius = 0.0; ///< 0 if there is no ground

  /// The ground below bounds. size: radius in half diagonals of the bounds.
  static GroundPlane Below(
    const std::array<double, 6>& bounds, const glm::dvec3& up, double offset, double size);

  /// Whether the camera sees its upper side.
  bool IsSeen(const View& view) const;
  std::array<double, 6> Bounds() const;
  /// Distances along the view direction of the visible part: nearest and farthest.
  glm::dvec2 DepthRange(const View& view) const;
  /// Uniforms of ground/plane.glsl.
  Arguments InView(const View& view) const;
  /// A disc for rays, of a diffuse colour.
  RayPart MakeRayPart(const glm::dvec3& color) const;
};
}
