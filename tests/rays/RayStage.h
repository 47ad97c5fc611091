// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A context to trace rays in, and the same rays through Embree on the CPU.
#pragma once

#include "RayScenes.h"

#include "gpu/ShaderLibrary.h"
#include "rays/RayScene.h"

#include "ray_query.h"

#include "vtkHeadlessRenderWindow.h"
#include "vtkSmartPointer.h"

namespace penumbra_test
{
using Rays = std::vector<penumbra::shared::RayQuery>;
using Answers = std::vector<penumbra::shared::RayAnswer>;

/// Time spent: by the clock, and by all threads of the process together, which others on the
/// machine disturb less.
struct Seconds
{
  double Wall = 0.0;
  double Cpu = 0.0;

  static Seconds Now();
  Seconds Since() const;
};

class RayStage
{
public:
  RayStage();
  ~RayStage();

  /// False where no context can be had here.
  bool IsReady() const { return this->Ready; }
  const char* Description() const;
  bool IsSoftware() const;

  /// Replace the scene by a world. Instances and meshes are named by their indices.
  void Show(const RayWorld& world);
  /// Trace. Hit.x of an answer is the index of the instance in the world.
  Answers Closest(const Rays& rays) { return this->Trace(rays, false); }
  Answers Any(const Rays& rays) { return this->Trace(rays, true); }
  /// Trace without moving data to or from the context, and say how long it took.
  Seconds Time(const Rays& rays, bool any = false);

  penumbra::RayScene Scene;

private:
  Answers Trace(const Rays& rays, bool any);
  void Prepare(const Rays& rays, bool any);
  void Dispatch(std::size_t count);

  vtkSmartPointer<vtkHeadlessRenderWindow> Window;
  penumbra::ShaderLibrary Library;
  penumbra::Buffer Queries;
  penumbra::Buffer Results;
  const penumbra::Program* Current = nullptr;
  bool Ready = false;
};

/// Embree over a world, in coordinates relative to the world's centre.
class EmbreeWorld
{
public:
  explicit EmbreeWorld(const RayWorld& world);
  ~EmbreeWorld();
  EmbreeWorld(const EmbreeWorld&) = delete;
  EmbreeWorld& operator=(const EmbreeWorld&) = delete;

  enum Mode
  {
    Single,  ///< rtcIntersect1
    Packets, ///< rtcIntersect8, marked coherent
    Occluded ///< rtcOccluded1
  };
  /// Trace on all cores, and say how long it took.
  Seconds Trace(const Rays& rays, Answers& answers, Mode mode = Single) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

/// Rays of every kind through a world: from inside in all directions, from outside at its
/// triangles.
Rays RandomRays(const RayWorld& world, std::size_t count, unsigned int seed);
/// From random points in all directions, in no order.
Rays IncoherentRays(const RayWorld& world, std::size_t count, unsigned int seed);
/// A camera's, in tiles of 8 by 8 pixels, in Morton order within a tile.
Rays CameraRays(const RayWorld& world, int width, int height);
}
