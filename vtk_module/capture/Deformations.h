// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Motion of points within their props since the previous frame, as in deforming data. It is known
 * if both frames have the same numbers of points and cells.
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
  /// Compare with the props of the last call. Returns whether any points moved.
  bool Update(const std::vector<vtkProp*>& props);

  /// Whether an actor's points moved and their displacements are known.
  bool HasDisplacements(vtkActor* actor) const;

  /// Buffer texture of the displacement of each point to its previous position, three floats in the prop's coordinates;
  /// 0 if none moved.
  GLuint TextureOf(vtkActor* actor) const;

private:
  struct Shape
  {
    vtkSmartPointer<vtkDataArray> Points; ///< kept alive until the next frame
    vtkMTimeType Time = 0;
    vtkIdType Cells = 0;
    bool InPlace = false;               ///< whether its points change within the same array
    std::vector<double> PreviousPoints; ///< copy of such points
    Buffer Displacements;
    Handle<gl::DeleteTexture> Texture;
    bool Moved = false;
  };
  static bool UploadDisplacements(Shape& shape, vtkDataArray* points, vtkIdType cells);

  std::map<vtkActor*, Shape> Shapes;
};
}
