// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A renderer's scene made ready for compute shaders outside of any frame: its rays, its lamps, and a
 * program with both bound.
 */
#pragma once

#include "gpu/ContextGuard.h"
#include "gpu/GLObjects.h"
#include "gpu/ShaderLibrary.h"
#include "light/LightTable.h"
#include "rays/RayProps.h"

#include "vtkNew.h"

class vtkRenderer;

namespace penumbra
{
class GatherStage
{
public:
  GatherStage();
  ~GatherStage();
  GatherStage(const GatherStage&) = delete;
  GatherStage& operator=(const GatherStage&) = delete;

  /// Open the renderer's window where need be, and bring the scene up to date. Throws
  /// std::runtime_error with a sentence where that cannot be done.
  void Prepare(vtkRenderer* renderer);

  /// A compute program of the scene in use, with what it needs of the scene bound.
  const Program& Use(const std::string& shader, Defines defines);

  /// Run so many groups of the program in use; the shader counts them along x, then y.
  static void Dispatch(std::size_t groups);

  /// Read back what a shader wrote to a buffer.
  static void Read(const Buffer& buffer, std::vector<float>& values);

  const glm::dvec3& Origin() const { return this->Rays.Origin(); }
  /// By how much coordinates of the scene may be off, world units.
  double Error() const { return this->Inaccuracy; }
  /// Lamps that follow the camera: they are left out.
  int LampsLeftOut() const { return this->Following; }
  std::size_t PropsLeftOut() const { return this->Rays.LeftOut(); }

  /// Free what is on the GPU.
  void Release();

  Buffer Points;
  Buffer Results;

private:
  void FreeAll();

  vtkNew<vtkGIContextGuard> Guard;
  vtkRenderer* Renderer = nullptr;
  RayProps Rays;
  LightTable Lamps;
  ShaderLibrary Shaders;
  double Inaccuracy = 0.0;
  int Following = 0;
};

/// How much work to give to the GPU at once, so that it answers within a fraction of a second.
class WorkSize
{
public:
  explicit WorkSize(std::size_t first)
    : Units(first)
  {
  }
  std::size_t Get() const { return this->Units; }
  /// So many were done in so many seconds.
  void Took(std::size_t units, double seconds);

private:
  std::size_t Units;
};
}
