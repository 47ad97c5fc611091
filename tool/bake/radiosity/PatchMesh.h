// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Diffuse triangles, subdivided into patches for radiosity.
#pragma once

#include "common/NumbersHash.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <unordered_map>
#include <vector>

namespace penumbra::radiosity
{
using Color = glm::dvec3; ///< red, green, blue, linear
using Point = glm::dvec3;
using Texture = std::function<Color(const glm::dvec2&)>;

/// One side of a surface. A tint is a colour that data assigns to a point or a cell.
struct SideMaterial
{
  bool Present = true; ///< false if it is not drawn from there, and light passes
  Color Reflectance{ 0.0 };
  Color Emission{ 0.0 };     ///< radiance
  double TintReflects = 0.0; ///< factor from tint to reflectance
  double TintEmits = 0.0;    ///< factor from tint to emission
  bool TintsEmission = false;
  Texture Base; ///< factor of the reflectance
  bool BaseOnEmission = false;
  Texture Glow; ///< factor of the emission
};

struct Surface
{
  enum TintSource
  {
    Untinted,
    OfPoints,
    OfFaces
  };
  TintSource Tints = Untinted;
  std::array<SideMaterial, 2> Sides; ///< front (corners counter-clockwise), back
};

struct Vertex
{
  Point At{ 0.0 };
  Color Tint{ 1.0 };
  glm::dvec2 Uv{ 0.0 };
};

struct Face
{
  std::array<std::uint32_t, 3> Corners{};
  std::uint32_t Surface = 0;
  std::uint32_t Input = 0; ///< the input face that it is part of
  Color Tint{ 1.0 };
  double MaximumEdge = std::numeric_limits<double>::infinity(); ///< inherited by its parts
};

class PatchMesh
{
public:
  /// Adds a triangle. Returns false and adds nothing if it is not finite or has no area.
  bool Add(const std::array<Vertex, 3>& corners, std::uint32_t surface, const Color& tint);
  std::uint32_t AddSurface(const Surface& surface);

  /// Sets the maximum length of a face's edges, for the next Refine().
  void Limit(std::size_t face, double longest) { this->Parts[face].MaximumEdge = longest; }
  void LimitAll(double longest);
  /// Subdivides faces with edges above their maximum, and neighbours so that no corner lies within an edge, by bisecting
  /// longest edges (Rivara 1984, Algorithms for Refining Triangular Grids Suitable for Adaptive and Multigrid Techniques).
  /// Returns false, with incomplete refinement, if there would be more than a maximum number of faces.
  bool Refine(std::size_t maximum);

  double LongestEdge(const Face& face) const;
  double Area(const Face& face) const;
  double TotalArea() const;
  /// The diagonal of the bounding box.
  double Diagonal() const;

  const std::vector<Vertex>& Vertices() const { return this->Corners; }
  const std::vector<Face>& Faces() const { return this->Parts; }
  const std::vector<Surface>& Surfaces() const { return this->Materials; }
  /// The faces before subdivision, which Face::Input refers to.
  const std::vector<Face>& InputFaces() const { return this->Inputs; }

private:
  using Edge = std::uint64_t;
  static Edge Between(std::uint32_t a, std::uint32_t b);
  double Length2(Edge edge) const;
  Edge Longest(const Face& face) const;
  void Link(std::uint32_t face);
  void Unlink(std::uint32_t face);
  void LinkAll();
  void BisectAround(std::uint32_t face);
  void Bisect(Edge edge);
  std::uint32_t FindOrAdd(const Vertex& vertex, std::uint32_t surface);

  std::vector<Vertex> Corners;
  std::vector<Face> Parts;
  std::vector<Face> Inputs;
  std::vector<Surface> Materials;
  std::unordered_map<Edge, std::vector<std::uint32_t>> Neighbours;
  tool::NumbersMap<9, std::uint32_t> VertexIndex; ///< by the vertex's numbers and surface
};
}
