// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A lightmap as one image of VTK, for files and for users: light at its points, and in its field data the surfaces that
 * the picture is laid over.
 */
#pragma once

#include "bake/BakeImage.h"

#include <array>

class vtkImageData;
class vtkPolyData;

namespace penumbra::lightmap_image
{
constexpr const char* Format = "penumbra lightmap 2";

/// Light at points, in this order: irradiance, its moments, the same of what arrives straight from lamps. The first is
/// always there, both of moments or none.
struct Layer
{
  const char* Name;
  int Components;
};
constexpr std::array<Layer, 4> Layers = { { { "light", 3 }, { "moments", 9 }, { "lamps", 3 },
  { "lamp moments", 9 } } };

/// Field data of surfaces: an entry for each point of triangles, and three points for each triangle.
constexpr const char* Points = "points";
constexpr const char* Normals = "normals";
constexpr const char* Places = "places";
constexpr const char* Triangles = "triangles";

/// What the baker alone knows: the first round's light, tiles of the picture, and how it was made.
constexpr const char* First = "first";
constexpr const char* Tiles = "tiles";
constexpr const char* TileKeys = "tile keys";
constexpr const char* Settings = "settings";
constexpr const char* Made = "made";

/// One image of surfaces and light as vtkGILightmap::SetBake() takes them. Throws std::invalid_argument with a reason.
void Join(vtkPolyData* surfaces, vtkImageData* light, vtkImageData* bake);

/// Adds the format and a checksum of all that was added by then.
void Seal(vtkImageData* bake);

/// Throws std::invalid_argument, saying why, where an image is none of Seal()'s.
void RequireWhole(vtkImageData* bake);
}
