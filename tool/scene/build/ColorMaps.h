// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Colour maps and the arrays they colour.
#pragma once

#include "scene/build/Surfaces.h"

#include <vtkLookupTable.h>

class vtkMapper;

namespace penumbra::tool
{
/// The names of the colour maps.
std::vector<std::string> ColorMapNames();

/// The map as a table of 256 colours over a range; throws a Failure for an unknown name.
vtkSmartPointer<vtkLookupTable> MakeColorMap(const std::string& name, const double range[2]);

/// The table that colours all parts by the array, over the range of its finite values in all of them.
/// Throws a Failure where no part has the array or the component.
vtkSmartPointer<vtkLookupTable> MakeColoring(
  const std::vector<Part>& parts, const ColorBy& color, const std::string& what);

/// Lets a mapper colour its data by the array, at points or at cells as it is there.
void ColorMapper(
  vtkMapper* mapper, vtkPolyData* geometry, const ColorBy& color, vtkLookupTable* table);
}
