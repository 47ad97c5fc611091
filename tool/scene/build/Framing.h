// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Places the camera so that the scene fills the picture.
#pragma once

#include "scene/model/Loaded.h"

class vtkPolyData;
class vtkRenderer;

namespace penumbra::tool
{
/// A sample of the points that must be in view.
class FramedPoints
{
public:
  /// Adds points of the geometry, placed by the matrix and with a margin in world units.
  void Add(vtkPolyData* geometry, vtkMatrix4x4* placed, double margin);
  const std::vector<Vec3>& Get() const { return this->Points; }

private:
  std::vector<Vec3> Points;
};

/// Sets the renderer's camera as described; what is not described is chosen so that all points are in
/// view, seen from the default side.
void SetCamera(const Camera& camera, const DefaultView& view, const FramedPoints& points,
  double aspect, vtkRenderer* renderer);
}
