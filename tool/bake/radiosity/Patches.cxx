// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/Patches.h"

#include <glm/gtc/constants.hpp>

namespace penumbra::radiosity
{
namespace
{
struct Appearance
{
  Color Reflectance{ 0.0 };
  Color Emission{ 0.0 };
};

Appearance AppearanceAt(
  const SideMaterial& side, bool tinted, const Color& tint, const glm::dvec2& uv)
{
  Appearance result = { side.Reflectance, side.Emission };
  if (tinted)
  {
    result.Reflectance = tint * side.TintReflects;
    result.Emission = side.TintsEmission ? tint * side.TintEmits : result.Emission;
  }
  if (side.Base)
  {
    const Color base = side.Base(uv);
    result.Reflectance *= base;
    result.Emission *= side.BaseOnEmission ? base : Color(1.0);
  }
  result.Emission *= side.Glow ? side.Glow(uv) : Color(1.0);
  return result;
}

/// The mean over a face, sampled on a grid if it has textures.
Appearance MeanAppearance(const PatchMesh& mesh, const Face& face, int s)
{
  const Surface& surface = mesh.Surfaces()[face.Surface];
  const SideMaterial& side = surface.Sides[s];
  const bool textured = side.Base || side.Glow;
  const bool tinted = surface.Tints != Surface::Untinted;
  const int grid = textured ? 6 : 1;
  Appearance sum;
  int count = 0;
  for (int i = 0; i < grid; ++i)
  {
    for (int j = 0; j + i < grid; ++j)
    {
      const double b = (i + 1.0 / 3.0) / grid;
      const double c = (j + 1.0 / 3.0) / grid;
      const double weights[3] = { 1.0 - b - c, b, c };
      Color tint = surface.Tints == Surface::OfFaces ? face.Tint : Color(0.0);
      glm::dvec2 uv(0.0);
      for (int k = 0; k < 3; ++k)
      {
        const Vertex& corner = mesh.Vertices()[face.Corners[k]];
        tint += surface.Tints == Surface::OfPoints ? weights[k] * corner.Tint : Color(0.0);
        uv += weights[k] * corner.Uv;
      }
      const Appearance point = AppearanceAt(side, tinted, tint, uv);
      sum.Reflectance += point.Reflectance;
      sum.Emission += point.Emission;
      ++count;
    }
  }
  return { sum.Reflectance / double(count), sum.Emission / double(count) };
}

Element MakeElement(const PatchMesh& mesh, const Face& face, int side)
{
  Element element;
  for (int i = 0; i < 3; ++i)
  {
    element.Corners[side == 0 ? i : (3 - i) % 3] = mesh.Vertices()[face.Corners[i]].At;
  }
  const auto& at = element.Corners;
  const Point across = glm::cross(at[1] - at[0], at[2] - at[0]);
  element.Area = 0.5 * glm::length(across);
  element.Normal = element.Area > 0.0 ? across / glm::length(across) : Point(0.0, 0.0, 1.0);
  element.Present = mesh.Surfaces()[face.Surface].Sides[side].Present;
  const Appearance mean = MeanAppearance(mesh, face, side);
  element.Reflectance = element.Present ? mean.Reflectance : Color(0.0);
  element.Emission = element.Present ? mean.Emission * glm::pi<double>() : Color(0.0);
  return element;
}

bool EmitsUniformly(const Surface& surface, int side)
{
  const SideMaterial& material = surface.Sides[side];
  return !material.Glow && !(material.Base && material.BaseOnEmission) &&
    !(surface.Tints == Surface::OfPoints && material.TintsEmission);
}

void AddEmitters(const PatchMesh& mesh, const std::vector<Face>& faces, bool uniform,
  std::vector<Element>& emitters)
{
  for (const Face& face : faces)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (EmitsUniformly(mesh.Surfaces()[face.Surface], side) != uniform)
      {
        continue;
      }
      const Element element = MakeElement(mesh, face, side);
      if (element.Emission != Color(0.0))
      {
        emitters.push_back(element);
      }
    }
  }
}
}

std::vector<Element> MakeElements(const PatchMesh& mesh)
{
  std::vector<Element> elements;
  elements.reserve(2 * mesh.Faces().size());
  for (const Face& face : mesh.Faces())
  {
    elements.push_back(MakeElement(mesh, face, 0));
    elements.push_back(MakeElement(mesh, face, 1));
  }
  return elements;
}

std::vector<Element> MakeEmitters(const PatchMesh& mesh)
{
  std::vector<Element> emitters;
  AddEmitters(mesh, mesh.InputFaces(), true, emitters);
  AddEmitters(mesh, mesh.Faces(), false, emitters);
  return emitters;
}
}
