// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A solution as polygons with arrays, for any program that reads VTK's files.
#pragma once

#include "bake/radiosity/Radiosity.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace penumbra::radiosity
{
/// The sides of patches that any light reaches, as triangles that face away from the surface. Cells:
/// radiosity and irradiance (W/m2), albedo, emission (radiance), error (standard error of the
/// irradiance). Points: radiosity, irradiance, and color, the radiance for display. Field: how it was
/// solved.
vtkSmartPointer<vtkPolyData> MakePolyData(const Solution& solution);

/// Writes a .vtp under another name first, so that there is never half a file; throws
/// std::runtime_error with a sentence.
void WriteSolution(const std::string& file, const Solution& solution);

/// Radiance as 8-bit displays show it: cut off at 1, with the exponent 1 / 2.2 of VTK's PBR shading.
double Display(double radiance);
}
