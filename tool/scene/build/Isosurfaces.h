// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Isosurfaces of volumes and grids.
#pragma once

#include "scene/build/Surfaces.h"

class vtkDataArray;
class vtkDataSet;

namespace penumbra::tool
{
/// One part for each of the object's isovalues, or for one that is chosen and reported.
std::vector<Part> MakeIsosurfaces(vtkDataSet* data, const Object& object, Reporter& reporter);

/// The value that best separates the finite values into two classes.
/// Otsu 1979, A Threshold Selection Method from Gray-Level Histograms.
double OtsuThreshold(vtkDataArray* values);
}
