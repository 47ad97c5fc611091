// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Output of a solution: VTK polygons with arrays, and pictures.
#pragma once

#include "bake/radiosity/Radiosity.h"
#include "image/Picture.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

namespace penumbra::radiosity
{
/// The sides of patches that any light reaches, as triangles that face away from the surface. Cell data: radiosity and
/// irradiance (W/m2), albedo, emission (radiance), error (standard error of the irradiance). Point data: radiosity,
/// irradiance, and color, the radiance for display. Field data: parameters and history of the solution.
vtkSmartPointer<vtkPolyData> MakePolyData(const Solution& solution);

/// Writes a .vtp file, which is always complete. Throws a Failure.
void WriteSolution(const std::string& file, const Solution& solution);

/// Radiance for 8-bit displays: clamped to 1, with the exponent 1 / 2.2 of VTK's PBR shading.
double DisplayValue(double radiance);

/// A picture of the radiance that the renderer's camera sees. Irradiance is interpolated between the corners of patches
/// unless flat. samples: rays per pixel, a square number.
tool::Picture DrawSolution(const Solution& solution, vtkRenderer* renderer, int width, int height,
  int samples, bool flat, const tool::Progress& advance = {});
}
