// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One piece of what a renderer shows, as the rays see it: a mesh, the attributes of its primitives
 * and points, a material, a place. Mappers are turned into parts by GatherRayParts().
 */
#pragma once

#include "rays/RayGeometry.h"

#include "ray_surface.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class vtkProp;
class vtkRenderer;
class vtkTexture;

namespace penumbra
{
/// What the shader looks up by primitive and by point.
struct RayAttributes
{
  std::vector<shared::RayAttribute> Primitives; ///< as many as the geometry's
  std::vector<shared::RayPoint> Points;
  bool LacksNormals = false; ///< some of the points' are zero or no numbers
};

/// What pictures on a surface are for: RaySurface::Pictures in their order, then its colour.
enum PictureSlot
{
  BasePicture,
  MaterialPicture,
  NormalPicture,
  EmissionPicture,
  ColorPicture,
  PictureSlots
};

struct RayPart
{
  /// Parts of the same MeshKey share a tree, of the same AttributeKey their attributes. Where a
  /// time differs from the last frame's, what belongs to it is made anew; where only the points'
  /// time differs, the tree is refitted.
  std::uint64_t MeshKey = 0;
  vtkMTimeType CellTime = 0;
  vtkMTimeType PointTime = 0;
  std::function<RayGeometry()> MakeGeometry;
  std::uint64_t AttributeKey = 0;
  vtkMTimeType AttributeTime = 0;
  std::function<RayAttributes()> MakeAttributes;

  vtkProp* Prop = nullptr;
  glm::dmat4 ToWorld{ 1.0 };
  shared::RaySurface Surface{};
  shared::RaySurface Back{}; ///< where HasBack
  bool HasBack = false;
  /// The mesh's places, each before ToWorld; null for the one place that ToWorld is. What they
  /// point to is never changed: other places are another vector.
  std::shared_ptr<const std::vector<RayPlace>> Places;
  std::array<vtkTexture*, PictureSlots> Pictures{}; ///< null where there are none
  std::vector<glm::dvec4> Clip; ///< planes in the world: what is below them is not there
};

class GatherCache;

/// The parts of all visible props. left: props with surfaces that rays do not see.
std::vector<RayPart> GatherRayParts(
  vtkRenderer* renderer, std::vector<vtkProp*>& left, GatherCache& cache);
}
