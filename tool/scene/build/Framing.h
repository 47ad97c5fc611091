// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Places the camera so that the scene fills the picture.
#pragma once

#include "scene/model/LoadedData.h"

class vtkPolyData;
class vtkRenderer;

namespace penumbra::tool
{
/// Adds a sample of the geometry's points to those that must be visible, after a transformation, with a margin in world
/// units.
void AddFramedPoints(
  vtkPolyData* geometry, vtkMatrix4x4* transform, double margin, std::vector<Vec3>& points);

/// Sets the renderer's camera as described. What is not described is chosen so that all points are visible from the default
/// view.
void SetCamera(const Camera& camera, const DefaultView& view, const std::vector<Vec3>& points,
  double aspect, vtkRenderer* renderer);
}
