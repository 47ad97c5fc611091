// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Triangles with a diffuse material, cut into patches: the surface that radiosity is solved on.
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

/// One side of a surface. A tint is a colour that data gives to a point or a cell.
struct SideMaterial
{
  bool Present = true; ///< false: seen from there it is not drawn, and light passes
  Color Reflectance{ 0.0 };
  Color Emission{ 0.0 };     ///< radiance
  double TintReflects = 0.0; ///< a tint's share that replaces the reflectance
  double TintEmits = 0.0;    ///< a tint's share that replaces the emission, as radiance
  bool TintsEmission = false;
  Texture Base; ///< times the reflectance
  bool BaseOnEmission = false;
  Texture Glow; ///< times the emission
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
  std::uint32_t Whole = 0; ///< the face of the input that it is a piece of
  Color Tint{ 1.0 };
  double LongestWanted = std::numeric_limits<double>::infinity(); ///< edge; its pieces inherit it
};

class PatchMesh
{
public:
  /// Adds a triangle; false, and nothing done, where a corner is not finite or it has no area.
  bool Add(const std::array<Vertex, 3>& corners, std::uint32_t surface, const Color& tint);
  std::uint32_t AddSurface(const Surface& surface);

  /// How long the face's edges may be at most, from the next Refine() on.
  void Limit(std::size_t face, double longest) { this->Pieces[face].LongestWanted = longest; }
  void LimitAll(double longest);
  /// Cuts every face with a longer edge than wanted, and of its neighbours as many as keep corners off
  /// edges. Longest edges are bisected: Rivara 1984, Algorithms for Refining Triangular Grids Suitable
  /// for Adaptive and Multigrid Techniques. False, and cut in part, where that would make more than so
  /// many faces.
  bool Refine(std::size_t most);

  double LongestEdge(const Face& face) const;
  double Area(const Face& face) const;
  double TotalArea() const;
  /// Of the box around all points.
  double Diagonal() const;

  const std::vector<Vertex>& Vertices() const { return this->Corners; }
  const std::vector<Face>& Faces() const { return this->Pieces; }
  const std::vector<Surface>& Surfaces() const { return this->Looks; }
  /// The faces as they were added; pieces name them by Face::Whole.
  const std::vector<Face>& Wholes() const { return this->Originals; }

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
  std::vector<Face> Pieces;
  std::vector<Face> Originals;
  std::vector<Surface> Looks;
  std::unordered_map<Edge, std::vector<std::uint32_t>> Neighbours;
  tool::NumbersMap<9, std::uint32_t> Known; ///< vertices by their numbers and surface
};
}
