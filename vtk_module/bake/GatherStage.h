// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Makes a renderer's scene available to compute shaders outside of any frame: the scene for rays and the lights.
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

  /// Open the renderer's window if necessary, and update the scene. Throws std::runtime_error with a sentence if that
  /// is not possible.
  void Prepare(vtkRenderer* renderer);

  /// Set the rules by which surfaces reflect.
  void SetRules(const SurfaceRules& rules) { this->TracedScene.SetRules(rules); }

  /// Run groups of a compute shader, which are numbered along x, then y. The shader gets the scene, Points, Results
  /// and the arguments.
  void Run(
    const std::string& shader, Defines variant, const Arguments& arguments, std::size_t groups);

  /// Read back Results.
  void Read(std::vector<float>& values);

  const glm::dvec3& Origin() const { return this->TracedScene.Origin(); }
  /// Maximum rounding error of the scene's coordinates, in world units.
  double Error() const { return this->CoordinateError; }
  /// Number of lights that are left out because they follow the camera.
  int LampsLeftOut() const { return this->FollowingLights; }
  std::size_t PropsLeftOut() const { return this->TracedScene.LeftOut(); }

  /// Free GPU resources.
  void Release();

  Buffer Points;
  Buffer Results;

private:
  void FreeAll();

  vtkNew<vtkGIContextGuard> Guard;
  vtkRenderer* Renderer = nullptr;
  RayProps TracedScene;
  LightTable Lights;
  ShaderLibrary Shaders;
  Commands Runner{ Shaders };
  double CoordinateError = 0.0;
  int FollowingLights = 0;
};

/// Amount of work to give to the GPU at once so that it finishes within a fraction of a second.
class WorkSize
{
public:
  explicit WorkSize(std::size_t first)
    : Units(first)
  {
  }
  std::size_t Get() const { return this->Units; }
  /// Adapt to the time that a number of units took.
  void Adapt(std::size_t units, double seconds);

private:
  std::size_t Units;
};
}
