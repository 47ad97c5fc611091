// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A renderer's scene made ready for compute shaders outside of any frame: its rays, its lamps, and a
 * program with both bound.
 */
#pragma once

#include "gpu/Commands.h"
#include "gpu/ContextGuard.h"
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

  /// Run so many groups of a compute shader, which counts them along x, then y, and is offered the scene, the points and
  /// the results. given: what else it takes.
  void Run(
    const std::string& shader, Defines variant, const Arguments& given, std::size_t groups);

  /// Read back what it wrote to the results.
  void Read(std::vector<float>& values);

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
  Commands Runner{ Shaders };
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
