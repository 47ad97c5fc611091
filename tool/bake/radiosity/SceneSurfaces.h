// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A renderer's surfaces and lights, as input of the radiosity solver.
#pragma once

#include "bake/radiosity/Radiosity.h"

class vtkRenderer;

namespace penumbra::radiosity
{
struct GatheredScene
{
  PatchMesh Mesh;
  Illumination Light;
};

/// All visible opaque surfaces in world coordinates, with their diffuse reflectance and emission, the lights, and the
/// environment. If polygons have cell arrays "albedo" and "emission" of three components, these replace the material. Prints
/// notes on what is left out. maximumAlbedo: factor of all reflectances, see vtkGIReflectance.
GatheredScene GatherScene(
  vtkRenderer* renderer, double maximumAlbedo, tool::Reporter& reporter);

/// The lights that are on; a light of colour c gives the irradiance pi c. Headlights are left out with a note.
Illumination GatherLights(vtkRenderer* renderer, tool::Reporter& reporter);
}
