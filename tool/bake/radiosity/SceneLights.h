// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A renderer's lights and environment as the radiosity solver takes them.
#pragma once

#include "bake/radiosity/Radiosity.h"

class vtkRenderer;

namespace penumbra::radiosity
{
/// The lights that are on, where the camera puts them; a light of colour c gives the irradiance pi c. A
/// headlight is left out, with a note: it would move with every view.
Illumination GatherLights(vtkRenderer* renderer, std::vector<std::string>& notes);
}
