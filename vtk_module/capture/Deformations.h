// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How the points of surfaces moved within their props since the frame before, as data that deform do:
 * for each point, where it was, where both frames hold the same number of points and cells.
 */
#pragma once

#include "gpu/GLObjects.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <map>
#include <vector>

class vtkActor;
class vtkProp;

namespace penumbra
{
class Deformations
{
public:
  /// Compare with the last call's props. Returns whether points of any moved.
  bool Update(const std::vector<vtkProp*>& props);

  /// Whether an actor's points moved, in a way that is known.
  bool Knows(vtkActor* actor) const;

  /// A buffer texture of the way back of each point, three floats in the prop's coordinates; 0 where
  /// none moved.
  GLuint TextureOf(vtkActor* actor) const;

  /// Any of them, to be bound where a shader asks for one and none is meant.
  GLuint AnyTexture() const;

private:
  struct Shape
  {
    vtkSmartPointer<vtkDataArray> Points; ///< kept alive until the next frame
    vtkMTimeType Time = 0;
    vtkIdType Cells = 0;
    bool InPlace = false;     ///< its points are written anew in the same array
    std::vector<double> Kept; ///< a copy of such points
    Buffer Displacements;
    Handle<gl::DeleteTexture> Texture;
    bool Moved = false;
  };
  static bool Follow(Shape& shape, vtkDataArray* points, vtkIdType cells);

  std::map<vtkActor*, Shape> Shapes;
};
}
