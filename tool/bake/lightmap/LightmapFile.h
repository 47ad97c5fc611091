// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A lightmap and its file: a VTK image (.vti) for vtkGILightmap, with additional data for a later bake.
#pragma once

#include "bake/lightmap/Light.h"

#include <vtkSmartPointer.h>

#include <cstdint>

class vtkImageData;

namespace penumbra::lightmap
{
/// A tile in the file, to be found by a later bake.
struct Patch
{
  glm::ivec2 At{ 0 };
  glm::ivec2 Texels{ 0 };
  std::uint64_t Key = 0; ///< hash of its texels' positions and normals
};

struct Lightmap
{
  Light Baked;
  Light Direct; ///< direct light; no channels if not baked
  Light First;  ///< unfiltered light of the first round of samples, for comparison by a later bake
  std::vector<Vec3> Points;                  ///< world
  std::vector<glm::vec3> Normals;            ///< for shading, towards the side of the triangle
  std::vector<glm::vec2> TextureCoordinates; ///< 0 to 1, with rows in the order of storage
  std::vector<glm::ivec3> Triangles;         ///< counter-clockwise as seen from their side
  std::vector<Patch> Patches;
  std::string Scene;    ///< BakedScene::ToText()
  std::string Made;     ///< description of settings
  std::string Settings; ///< settings that must be the same to reuse light
};

/// Adds the triangles of all tiles.
void AddSurfaces(Lightmap& lightmap, const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas);

/// The image for vtkGILightmap::SetBake(). Light is rounded to half precision, for small files.
vtkSmartPointer<vtkImageData> MakeImage(const Lightmap& lightmap);

/// Throws a Failure.
void WriteLightmap(const std::string& path, const Lightmap& lightmap);

/// Reads the data for a later bake, without surfaces and direct light. Throws a Failure.
Lightmap ReadLightmap(const std::string& path);

/// Reads the old format of lightmaps: OpenEXR with a picture of the light, and parts with tables. Throws a Failure.
Lightmap ReadOldLightmap(const std::string& path);
/// Whether a file is in OpenEXR format.
bool IsOpenExr(const std::string& path);
}
