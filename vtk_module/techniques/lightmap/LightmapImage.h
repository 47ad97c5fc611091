// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A lightmap as one vtkImageData: light at its points, and the surfaces it lies on in its field data.
 */
#pragma once

#include "bake/BakeImage.h"

#include <array>

class vtkImageData;
class vtkPolyData;

namespace penumbra::lightmap_image
{
constexpr const char* Format = "penumbra lightmap 2";

/// Arrays of light at points: irradiance, its moments, and the same for light straight from the lamps. The first is
/// always there.
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

/// For baking again: light of the first round of samples, tiles of the picture, settings.
constexpr const char* First = "first";
constexpr const char* Tiles = "tiles";
constexpr const char* Settings = "settings";
constexpr const char* Made = "made";

/// Makes one image of surfaces and light, as vtkGILightmap::JoinBake() does. Throws std::invalid_argument with a reason.
void Join(vtkPolyData* surfaces, vtkImageData* light, vtkImageData* bake);

/// Adds the format and the checksum; to be called last.
void Seal(vtkImageData* bake);

/// Throws std::invalid_argument with a reason where Seal() did not leave the image as it is.
void RequireWhole(vtkImageData* bake);
}
