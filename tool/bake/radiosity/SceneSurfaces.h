// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A renderer's surfaces and lights as the radiosity solver takes them.
#pragma once

#include "bake/radiosity/Radiosity.h"

class vtkRenderer;

namespace penumbra::radiosity
{
struct GatheredScene
{
  PatchMesh Mesh;
  Illumination Light;
  std::vector<std::string> Notes; ///< what is left out, a sentence each
};

/// All visible opaque surfaces in world coordinates, as rays see them, with what they reflect
/// diffusely and emit; cell arrays "albedo" and "emission" of three components, where polygons have
/// them, in place of their look. And the lights, and the environment where it lights.
GatheredScene GatherScene(vtkRenderer* renderer);
}
