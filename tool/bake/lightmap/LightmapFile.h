// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A baked lightmap and its file: a VTK image (.vti) as vtkGILightmap takes it, with what another bake needs.
#pragma once

#include "bake/lightmap/Light.h"

#include <vtkSmartPointer.h>

#include <cstdint>

class vtkImageData;

namespace penumbra::lightmap
{
/// A tile as the file knows it, so that another bake finds it again.
struct Patch
{
  glm::ivec2 At{ 0 };
  glm::ivec2 Texels{ 0 };
  std::uint64_t Key = 0; ///< of its texels' places and normals
};

struct Lightmap
{
  Light Baked;
  Light Lamps; ///< what arrives straight from lamps; without channels where that is not baked
  Light First; ///< what the first round of samples gave, unfiltered: a later bake compares with it
  std::vector<Vec3> Points;          ///< world
  std::vector<glm::vec3> Normals;    ///< for shading, to the side that the triangle is of
  std::vector<glm::vec2> Places;     ///< in the picture, 0 to 1, rows counted as stored
  std::vector<glm::ivec3> Triangles; ///< counter-clockwise where the side is seen that they are of
  std::vector<Patch> Patches;
  std::string Scene;    ///< BakedScene::ToText()
  std::string Made;     ///< how: settings, in words
  std::string Settings; ///< what must be the same for the light to be compared with
};

/// The triangles of all tiles.
void AddSurfaces(Lightmap& lightmap, const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas);

/// The image for vtkGILightmap::SetBake(). Light is rounded to half precision, so that files are small.
vtkSmartPointer<vtkImageData> MakeImage(const Lightmap& lightmap);

/// Throws a Failure.
void WriteLightmap(const std::string& path, const Lightmap& lightmap);

/// Reads what another bake compares with, which leaves out surfaces and the lamps' light. Throws a Failure.
Lightmap ReadLightmap(const std::string& path);

/// The old form of lightmaps: OpenEXR with a picture of the light and parts that hold tables. Throws a Failure.
Lightmap ReadOldLightmap(const std::string& path);
/// Whether a file is OpenEXR, of whatever content.
bool IsOpenExr(const std::string& path);
}
