// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A part of a renderer's scene for ray tracing: a mesh, the attributes of its primitives
 * and points, a material, a transformation. GatherRayParts() converts mappers to parts.
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
/// Attributes that the shader looks up by primitive and by point.
struct RayAttributes
{
  std::vector<shared::RayAttribute> Primitives; ///< one per primitive of the geometry
  std::vector<shared::RayPoint> Points;
  bool LacksNormals = false; ///< whether some points have a normal that is zero or NaN
};

/// Roles of images on a surface: those of RaySurface::Pictures in order, then its colour.
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
  /// Parts with the same MeshKey share a tree; parts with the same AttributeKey share their attributes. If a
  /// time differs from the previous frame's, the corresponding data is rebuilt; if only PointTime
  /// differs, the tree is refitted.
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
  shared::RaySurface Back{}; ///< material of back faces, if HasBack
  bool HasBack = false;
  /// Transformations of the mesh's instances, each applied before ToWorld; null for a single instance at ToWorld. The
  /// vector is never modified: different places are a different vector.
  std::shared_ptr<const std::vector<RayPlace>> Places;
  std::array<vtkTexture*, PictureSlots> Pictures{}; ///< null if there is none
  std::vector<glm::dvec4>
    Clip; ///< clipping planes in world coordinates; the negative side is removed
};

class GatherCache;

/// Gather the parts of all visible props. left: set to the props with surfaces that rays do not see.
std::vector<RayPart> GatherRayParts(
  vtkRenderer* renderer, std::vector<vtkProp*>& left, GatherCache& cache);
}
