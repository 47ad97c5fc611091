// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Conversion between VTK's row-major matrices and GLM's column-major ones.
 */
#pragma once

#include "vtkMatrix4x4.h"

#include <glm/glm.hpp>

namespace penumbra
{
inline glm::dvec3 ToVec3(const double* v)
{
  return { v[0], v[1], v[2] };
}

inline glm::dmat4 ToMatrix(vtkMatrix4x4* m)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = m->GetElement(row, column);
    }
  }
  return result;
}

/// Copy to a matrix of vtkOpenGLCamera, which stores its matrices transposed.
inline void ToTransposed(const glm::dmat4& m, vtkMatrix4x4* result)
{
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result->SetElement(column, row, m[column][row]);
    }
  }
}
}
