// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays traced by shaders in a context, and by Embree on the CPU.
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

/// Elapsed time, and processor time of all threads, which other programs on the machine disturb less.
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

  /// False if there is no context.
  bool IsReady() const { return this->Ready; }
  const char* Description() const;
  /// Whether the scene's trees fit the short stack (shared/ray_scene.h).
  bool IsShallow() const;

  /// Take shaders from a folder where it has them.
  void OverrideShaders(const std::string& folder) { this->Library.SetOverrideFolder(folder); }
  /// Replace the scene by a world. Instances and meshes are named by their indices.
  void Show(const RayWorld& world);
  /// Trace rays to the closest hit or to any hit. Hit.x of an answer is the index of the instance in the world.
  Answers Closest(const Rays& rays) { return this->Trace(rays, false); }
  Answers Any(const Rays& rays) { return this->Trace(rays, true); }
  /// Time of tracing alone, without transfers to or from the context.
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

/// A world in Embree, in coordinates relative to its centre.
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
  /// Trace on all cores. Returns the time.
  Seconds Trace(const Rays& rays, Answers& answers, Mode mode = Single) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

/// Rays of two kinds in turn: from inside a world in random directions, from outside toward its triangles.
Rays RandomRays(const RayWorld& world, std::size_t count, unsigned int seed);
/// Rays from random points in random directions, in no order.
Rays IncoherentRays(const RayWorld& world, std::size_t count, unsigned int seed);
/// Rays of a camera, in tiles of 8 by 8 pixels, in Morton order within a tile.
Rays CameraRays(const RayWorld& world, int width, int height);
}
