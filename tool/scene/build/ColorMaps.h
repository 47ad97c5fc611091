// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Colour maps.
#pragma once

#include "scene/build/Surfaces.h"

#include <vtkLookupTable.h>

class vtkMapper;

namespace penumbra::tool
{
/// The table that colours all parts by an array, over the range of its finite values in all parts. Throws a Failure if no
/// part has the array or the component.
vtkSmartPointer<vtkLookupTable> MakeColoring(
  const std::vector<Part>& parts, const ColorBy& color, const std::string& what);

/// Makes a mapper colour its data by an array at points or cells.
void ColorMapper(
  vtkMapper* mapper, vtkPolyData* geometry, const ColorBy& color, vtkLookupTable* table);
}
