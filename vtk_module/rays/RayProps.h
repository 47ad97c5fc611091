// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A renderer's props prepared for ray tracing: their parts in a RayScene, and the materials, attributes and
 * emitters that a shader looks up at a hit (rays/surface.glsl).
 */
#pragma once

#include "gpu/GLObjects.h"
#include "rays/RayEmitters.h"
#include "rays/RayPart.h"
#include "rays/RayPictures.h"
#include "rays/RayScene.h"
#include "rays/RaySky.h"
#include "rays/SurfaceRules.h"
#include "rays/parts/GatherCache.h"

#include <cstdint>
#include <set>

namespace penumbra
{
class RayProps
{
public:
  /// Bring everything up to date with the renderer's visible props. Only changes cost time. Throws
  /// std::runtime_error if the scene does not fit into memory. The context must be current. others: surfaces that are
  /// no props.
  void Update(vtkRenderer* renderer, const std::vector<RayPart>& others = {});

  /// Set the rules by which surfaces reflect, from the next frame's shaders on.
  void SetRules(const SurfaceRules& rules) { this->Rules = rules; }

  /// Arguments of shaders that include rays/surface.glsl and rays/sky.glsl, with emitterCount.
  Arguments ShaderArguments() const;
  Defines ShaderDefines() const;

  /// Arguments with mean radiances of the environment, for a number of rays distributed evenly over all directions.
  Arguments SkyCells(int rays);

  const glm::dvec3& Origin() const { return this->Scene.Origin(); }
  bool Contains(vtkProp* prop) const { return this->TracedProps.count(prop) > 0; }
  /// Number of visible props with surfaces that rays do not see.
  std::size_t LeftOut() const { return this->LeftOutCount; }
  /// Number of surfaces with points that have no usable normal.
  std::size_t WithoutNormals() const { return this->LackNormals; }
  std::size_t Bytes() const { return this->Scene.Bytes(); }
  std::size_t Triangles() const { return this->Primitives; }
  bool HasEmitters() const { return this->Emitters.Count() > 0; }
  /// Whether rays should be sent to emitters from where other rays end, because chance and probes resolve them badly:
  /// whether there are some, and they are small in a scene of this diagonal.
  bool SeeksEmitters(double diagonal) const
  {
    return this->HasEmitters() && this->Emitters.Area() < 0.1 * diagonal * diagonal;
  }

  void ReleaseGraphicsResources();

private:
  struct Block
  {
    std::size_t FirstPrimitive = 0, PrimitiveCount = 0;
    std::size_t FirstPoint = 0, PointCount = 0;
    vtkMTimeType Time = 0;
    bool Used = false;
    bool LacksNormals = false;
  };
  struct Shape
  {
    vtkMTimeType CellTime = 0;
    vtkMTimeType PointTime = 0;
    std::size_t Size = 0;
    bool Used = false;
  };
  struct Place
  {
    std::uint64_t Mesh = 0;
    glm::dmat4 ToWorld{ 0.0 };
    std::int32_t Surface = -1;
    RayScene::Places Many;
  };

  void UpdateMeshes(const std::vector<RayPart>& parts);
  void UpdateAttributes(const std::vector<RayPart>& parts);
  /// Set the images of a part's surfaces. Returns the mean colour of the image that scales their emission.
  glm::vec3 UpdatePictures(const RayPart& part, shared::RaySurface* surfaces, std::size_t count);
  void UpdateClipping(const std::vector<RayPart>& parts, std::vector<shared::RaySurface>& surfaces,
    const std::vector<std::int32_t>& indices);
  void UpdatePlaces(const std::vector<RayPart>& parts, const std::vector<std::int32_t>& surfaces);

  SurfaceRules Rules;
  GatherCache Cache;
  RayScene Scene;
  RayBuffer Attributes{ "attributes of triangles", 1 };
  RayPictures Pictures;
  RaySky Sky;
  RayBuffer Points{ "attributes of points", 1 };
  Buffer SurfaceStorage;
  RayEmitters Emitters;
  std::map<std::uint64_t, Shape> Shapes;
  std::map<std::uint64_t, Block> Blocks;
  std::vector<Place> Places;
  std::vector<shared::RaySurface> Surfaces;
  std::vector<glm::vec4> Planes; ///< clipping planes, stored among the points from FirstPlane on
  std::size_t FirstPlane = 0;
  std::set<vtkProp*> TracedProps;
  std::size_t LackNormals = 0;
  std::size_t LeftOutCount = 0;
  std::size_t Primitives = 0;
  bool Partly = false;
  bool Edges = false;
};
}
