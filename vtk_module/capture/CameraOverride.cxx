// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/CameraOverride.h"

#include "base/Matrices.h"

#include "vtkMatrix3x3.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderer.h"

namespace penumbra
{
namespace
{
struct KeyMatrices
{
  explicit KeyMatrices(vtkOpenGLRenderer* renderer)
  {
    static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera())
      ->GetKeyMatrices(
        renderer, this->WorldToView, this->Normal, this->ViewToClip, this->WorldToClip);
  }
  vtkMatrix4x4* WorldToView = nullptr;
  vtkMatrix3x3* Normal = nullptr;
  vtkMatrix4x4* ViewToClip = nullptr;
  vtkMatrix4x4* WorldToClip = nullptr;
};

glm::dmat4 FromTransposed(vtkMatrix4x4* m)
{
  return glm::transpose(ToMatrix(m));
}
}

glm::dmat4 CameraOverride::WorldToView(vtkOpenGLRenderer* renderer)
{
  return FromTransposed(KeyMatrices(renderer).WorldToView);
}

glm::dmat4 CameraOverride::ViewToClip(vtkOpenGLRenderer* renderer)
{
  return FromTransposed(KeyMatrices(renderer).ViewToClip);
}

CameraOverride::CameraOverride(
  vtkOpenGLRenderer* renderer, const glm::dmat4& worldToView, const glm::dmat4& viewToClip)
  : Renderer(renderer)
  , SavedWorldToView(WorldToView(renderer))
  , SavedViewToClip(ViewToClip(renderer))
{
  this->Store(worldToView, viewToClip);
}

CameraOverride::~CameraOverride()
{
  this->Store(this->SavedWorldToView, this->SavedViewToClip);
}

void CameraOverride::Store(const glm::dmat4& worldToView, const glm::dmat4& viewToClip)
{
  KeyMatrices key(this->Renderer);
  ToTransposed(worldToView, key.WorldToView);
  ToTransposed(viewToClip, key.ViewToClip);
  ToTransposed(viewToClip * worldToView, key.WorldToClip);
  // VTK multiplies normals as row vectors by the inverse of the upper left of the matrix.
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(worldToView));
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      key.Normal->SetElement(row, column, inverse[column][row]);
    }
  }
}
}
