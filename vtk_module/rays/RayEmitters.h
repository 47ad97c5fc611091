// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The triangles of the scene that emit light, for shaders that choose points of them (rays/emitters.glsl).
 */
#pragma once

#include "gpu/Arguments.h"
#include "rays/RayBuffer.h"
#include "rays/RayPart.h"

#include "ray_surface.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace penumbra
{
class RayEmitters
{
public:
  /// Find the parts that emit light, and mark their surfaces. indices: the surface of each part;
  /// meanColors: of the image that scales its emission; origin: of the scene. Only changes of emitters cost time.
  void Update(const std::vector<RayPart>& parts, std::vector<shared::RaySurface>& surfaces,
    const std::vector<std::int32_t>& indices, const std::vector<glm::vec3>& meanColors,
    const glm::dvec3& origin);

  std::size_t Count() const { return this->Triangles; }
  /// Effective area: the square of the sum of the emitters' powers, divided by the sum of their areas times the squares
  /// of their radiances. Faint emitters hardly count.
  double Area() const { return this->WholeArea; }
  void AddTo(Arguments& arguments) const;
  void ReleaseGraphicsResources();

private:
  /// A part that emits light, and all that its triangles depend on.
  struct EmittingPart
  {
    std::size_t Part;
    std::int32_t Surface;
    double Strength;
    std::uint64_t MeshKey;
    vtkMTimeType CellTime;
    vtkMTimeType PointTime;
    glm::dmat4 ToWorld;
    std::shared_ptr<const std::vector<RayPlace>> Places;
    float Density = 0.0f;  ///< of a choice of its points by their power
    float Fineness = 0.0f; ///< triangles per area

    bool HasTrianglesOf(const EmittingPart& other) const;
  };
  void Build(const std::vector<RayPart>& parts, const glm::dvec3& origin);

  std::vector<EmittingPart> Parts;
  RayBuffer Records{ "emitters", 3 };
  std::size_t Triangles = 0;
  int Levels = 0; ///< see EmitterTree
  glm::vec4 Cube{ 0.0f };
  double WholeArea = 0.0;
  glm::dvec3 Origin{ 0.0 };
  bool Built = false;
};
}
