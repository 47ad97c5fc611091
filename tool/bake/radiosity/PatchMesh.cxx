// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/PatchMesh.h"

#include <vtkBoundingBox.h>

#include <algorithm>
#include <cmath>

namespace penumbra::radiosity
{
namespace
{
bool IsFinite(const Point& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Vertex Middle(const Vertex& a, const Vertex& b)
{
  return { 0.5 * (a.At + b.At), 0.5 * (a.Tint + b.Tint), 0.5 * (a.Uv + b.Uv) };
}
}

bool PatchMesh::Add(const std::array<Vertex, 3>& corners, std::uint32_t surface, const Color& tint)
{
  const Point& a = corners[0].At;
  const Point& b = corners[1].At;
  const Point& c = corners[2].At;
  if (!IsFinite(a) || !IsFinite(b) || !IsFinite(c))
  {
    return false;
  }
  // The normals of thinner triangles are rounding errors.
  constexpr double thinnest = 1e-12;
  const double longest = std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) });
  if (!(glm::length(glm::cross(b - a, c - a)) > thinnest * longest * longest))
  {
    return false;
  }
  Face face;
  for (int i = 0; i < 3; ++i)
  {
    face.Corners[i] = this->FindOrAdd(corners[i], surface);
  }
  face.Surface = surface;
  face.Input = static_cast<std::uint32_t>(this->Inputs.size());
  face.Tint = tint;
  this->Parts.push_back(face);
  this->Inputs.push_back(face);
  return true;
}

std::uint32_t PatchMesh::AddSurface(const Surface& surface)
{
  this->Materials.push_back(surface);
  return static_cast<std::uint32_t>(this->Materials.size() - 1);
}

std::uint32_t PatchMesh::FindOrAdd(const Vertex& vertex, std::uint32_t surface)
{
  const Point& p = vertex.At;
  const Color& t = vertex.Tint;
  const auto next = static_cast<std::uint32_t>(this->Corners.size());
  const auto found = this->VertexIndex.emplace(
    std::array{ p.x, p.y, p.z, t.x, t.y, t.z, vertex.Uv.x, vertex.Uv.y, double(surface) }, next);
  if (found.second)
  {
    this->Corners.push_back(vertex);
  }
  return found.first->second;
}

PatchMesh::Edge PatchMesh::Between(std::uint32_t a, std::uint32_t b)
{
  return static_cast<Edge>(std::min(a, b)) << 32 | std::max(a, b);
}

double PatchMesh::Length2(Edge edge) const
{
  const Point along = this->Corners[edge & 0xffffffffu].At - this->Corners[edge >> 32].At;
  return glm::dot(along, along);
}

/// The longest edge. Among edges of the same length it is the one with the greatest index, so that neighbours agree.
PatchMesh::Edge PatchMesh::Longest(const Face& face) const
{
  Edge longest = 0;
  double length = -1.0;
  for (int i = 0; i < 3; ++i)
  {
    const Edge edge = Between(face.Corners[i], face.Corners[(i + 1) % 3]);
    const double own = this->Length2(edge);
    if (own > length || (own == length && edge > longest))
    {
      longest = edge;
      length = own;
    }
  }
  return longest;
}

double PatchMesh::LongestEdge(const Face& face) const
{
  return std::sqrt(this->Length2(this->Longest(face)));
}

double PatchMesh::Area(const Face& face) const
{
  const Point& a = this->Corners[face.Corners[0]].At;
  return 0.5 *
    glm::length(
      glm::cross(this->Corners[face.Corners[1]].At - a, this->Corners[face.Corners[2]].At - a));
}

double PatchMesh::TotalArea() const
{
  double total = 0.0;
  for (const Face& face : this->Parts)
  {
    total += this->Area(face);
  }
  return total;
}

double PatchMesh::Diagonal() const
{
  vtkBoundingBox bounds;
  for (const Vertex& vertex : this->Corners)
  {
    bounds.AddPoint(vertex.At.x, vertex.At.y, vertex.At.z);
  }
  return bounds.IsValid() ? bounds.GetDiagonalLength() : 0.0;
}

void PatchMesh::Link(std::uint32_t face)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto& corners = this->Parts[face].Corners;
    this->Neighbours[Between(corners[i], corners[(i + 1) % 3])].push_back(face);
  }
}

void PatchMesh::Unlink(std::uint32_t face)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto& corners = this->Parts[face].Corners;
    const auto found = this->Neighbours.find(Between(corners[i], corners[(i + 1) % 3]));
    auto& faces = found->second;
    faces.erase(std::remove(faces.begin(), faces.end(), face), faces.end());
    if (faces.empty())
    {
      this->Neighbours.erase(found);
    }
  }
}

void PatchMesh::LinkAll()
{
  if (this->Neighbours.empty())
  {
    for (std::uint32_t i = 0; i < this->Parts.size(); ++i)
    {
      this->Link(i);
    }
  }
}

void PatchMesh::Bisect(Edge edge)
{
  const auto a = static_cast<std::uint32_t>(edge >> 32);
  const auto b = static_cast<std::uint32_t>(edge & 0xffffffffu);
  const auto middle = static_cast<std::uint32_t>(this->Corners.size());
  this->Corners.push_back(Middle(this->Corners[a], this->Corners[b]));
  const std::vector<std::uint32_t> faces = this->Neighbours.at(edge);
  for (const std::uint32_t face : faces)
  {
    this->Unlink(face);
    Face half = this->Parts[face];
    std::replace(half.Corners.begin(), half.Corners.end(), a, middle);
    auto& other = this->Parts[face].Corners;
    std::replace(other.begin(), other.end(), b, middle);
    this->Parts.push_back(half);
    this->Link(face);
    this->Link(static_cast<std::uint32_t>(this->Parts.size() - 1));
  }
}

/// Bisects the longest edge of a face, but first those of neighbours with longer edges.
void PatchMesh::BisectAround(std::uint32_t face)
{
  const Edge target = this->Longest(this->Parts[face]);
  while (this->Neighbours.count(target) > 0)
  {
    Edge edge = target;
    // Edges become longer along the way, so the loop ends.
    for (bool ended = false; !ended;)
    {
      ended = true;
      for (const std::uint32_t next : this->Neighbours.at(edge))
      {
        const Edge longest = this->Longest(this->Parts[next]);
        if (longest != edge)
        {
          edge = longest;
          ended = false;
          break;
        }
      }
    }
    this->Bisect(edge);
  }
}

void PatchMesh::LimitAll(double longest)
{
  for (Face& face : this->Parts)
  {
    face.MaximumEdge = longest;
  }
}

bool PatchMesh::Refine(std::size_t maximum)
{
  this->LinkAll();
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    while (this->LongestEdge(this->Parts[i]) > this->Parts[i].MaximumEdge)
    {
      if (this->Parts.size() >= maximum)
      {
        return false;
      }
      this->BisectAround(static_cast<std::uint32_t>(i));
    }
  }
  return this->Parts.size() <= maximum;
}
}
