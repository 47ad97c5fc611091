// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours of a dataset, mapped from its scalars by a mapper.
 */
#pragma once

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkType.h"

#include <cstdint>

class vtkDataSet;
class vtkMapper;
class vtkUnsignedCharArray;

namespace penumbra
{
class GatherCache;

struct ScalarColors
{
  vtkSmartPointer<vtkUnsignedCharArray> Array; ///< null if there are none
  int Association = 0;   ///< 0: colours of points; 1: colours of cells; 2: a single colour
  bool Partly = false;   ///< whether some colours are translucent
  vtkMTimeType Time = 0; ///< time of the mapping
  /// If colours are looked up per pixel: the table, and the points' coordinates in it.
  vtkSmartPointer<vtkTexture> Table;
  vtkSmartPointer<vtkDataArray> Places;

  bool Has(vtkIdType i) const;
  /// Colour as RGBA8; white if the index has none.
  std::uint32_t At(vtkIdType i) const;

  vtkMTimeType SourceTime = 0;
  double Alpha = -1.0;
};

/// Map the scalars of a dataset as the mapper would, or return the cached result. The mapper is not
/// changed, as its own colours may be those of another block.
const ScalarColors& MapScalarColors(
  GatherCache& cache, vtkMapper* mapper, vtkDataSet* data, double alpha = 1.0);
}
