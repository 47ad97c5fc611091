// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A picture of a solution, by one ray or more through each pixel.
#pragma once

#include "bake/radiosity/Radiosity.h"

#include "image/Picture.h"

class vtkRenderer;

namespace penumbra::radiosity
{
/// The radiance that a renderer's camera sees; nothing is lit again. Irradiance is interpolated
/// between the corners of patches unless flat is asked for. samples: rays a pixel, a square number.
tool::Picture DrawSolution(const Solution& solution, vtkRenderer* renderer, int width, int height,
  int samples, bool flat, const tool::Progress& advance = {});
}
