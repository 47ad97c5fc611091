// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RadiosityScenes.h"

#include <glm/gtc/constants.hpp>

using namespace penumbra::radiosity;

namespace penumbra_test
{
std::uint32_t AddMatte(PatchMesh& mesh, const Color& reflectance, const Color& emission)
{
  Surface surface;
  for (SideMaterial& side : surface.Sides)
  {
    side.Reflectance = reflectance;
    side.Emission = emission;
  }
  return mesh.AddSurface(surface);
}

void AddQuad(PatchMesh& mesh, const std::array<Point, 4>& corners, std::uint32_t surface)
{
  std::array<Vertex, 4> at;
  for (int i = 0; i < 4; ++i)
  {
    at[i].At = corners[i];
  }
  mesh.Add({ at[0], at[1], at[2] }, surface, Color(1.0));
  mesh.Add({ at[0], at[2], at[3] }, surface, Color(1.0));
}

void AddBox(
  PatchMesh& mesh, const Point& low, const Point& high, std::uint32_t surface, bool inside)
{
  const auto corner = [&](int i) {
    return Point((i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z);
  };
  // Seen from outside.
  const int faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& f : faces)
  {
    const std::array<Point, 4> out = { corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]) };
    AddQuad(mesh, inside ? std::array<Point, 4>{ out[0], out[3], out[2], out[1] } : out, surface);
  }
}

void AddDisc(PatchMesh& mesh, double radius, double z, bool up, std::uint32_t surface)
{
  constexpr int corners = 720;
  const auto rim = [&](int i) {
    const double angle = 2.0 * glm::pi<double>() * (i % corners) / corners;
    Vertex vertex;
    vertex.At = Point(radius * std::cos(angle), radius * std::sin(angle), z);
    return vertex;
  };
  Vertex middle;
  middle.At = Point(0.0, 0.0, z);
  for (int i = 0; i < corners; ++i)
  {
    mesh.Add({ middle, rim(up ? i : i + 1), rim(up ? i + 1 : i) }, surface, Color(1.0));
  }
}

void Cut(PatchMesh& mesh, double size)
{
  mesh.LimitAll(size);
  mesh.Refine(1000000);
}
}
