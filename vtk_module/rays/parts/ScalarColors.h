// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The colours that a mapper gives a dataset by its scalars.
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
  vtkSmartPointer<vtkUnsignedCharArray> Array; ///< null where there are none
  int Association = 0;   ///< 0: the colours of points; 1: of cells; 2: one, of all
  bool Partly = false;   ///< some are translucent
  vtkMTimeType Time = 0; ///< when they were mapped
  /// Where colours are looked up per pixel: the table, and where in it each point is.
  vtkSmartPointer<vtkTexture> Table;
  vtkSmartPointer<vtkDataArray> Places;

  bool Has(vtkIdType i) const;
  /// RGBA8, white beyond the colours there are.
  std::uint32_t At(vtkIdType i) const;

  vtkMTimeType SourceTime = 0;
  double Alpha = -1.0;
};

/// Map the scalars of a dataset as the mapper would, or find that nothing changed. The mapper is left
/// as it is: its own colours may be those of another block.
const ScalarColors& MapScalarColors(
  GatherCache& cache, vtkMapper* mapper, vtkDataSet* data, double alpha = 1.0);
}
