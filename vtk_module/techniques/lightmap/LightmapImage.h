// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A lightmap as one vtkImageData: light in its point data, and the lit surfaces in its field data.
 */
#pragma once

#include "bake/BakeImage.h"

#include <array>

class vtkImageData;
class vtkPolyData;

namespace penumbra::lightmap_image
{
constexpr const char* Format = "penumbra lightmap 2";

/// Arrays of light in the point data: irradiance, its moments, and the same for direct light. Only the first is
/// required.
struct Layer
{
  const char* Name;
  int Components;
};
constexpr std::array<Layer, 4> Layers = { { { "light", 3 }, { "moments", 9 }, { "lamps", 3 },
  { "lamp moments", 9 } } };

/// Surfaces, in field data: one tuple per point, then three point numbers per triangle.
constexpr const char* Points = "points";
constexpr const char* Normals = "normals";
constexpr const char* Places = "places";
constexpr const char* Triangles = "triangles";

/// Data for updating the bake: light of the first round of samples, tiles of the picture, settings.
constexpr const char* First = "first";
constexpr const char* Tiles = "tiles";
constexpr const char* Settings = "settings";
constexpr const char* Made = "made";

/// Join surfaces and light to one image, as vtkGILightmap::JoinBake() does. Throws std::invalid_argument with a reason.
void Join(vtkPolyData* surfaces, vtkImageData* light, vtkImageData* bake);

/// Add the format and the checksum. Must be called last.
void Seal(vtkImageData* bake);

/// Throws std::invalid_argument with a reason if the image was changed after Seal().
void RequireWhole(vtkImageData* bake);
}
