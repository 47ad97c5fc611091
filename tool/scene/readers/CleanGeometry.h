// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Removes what cannot be drawn.
#pragma once

#include "common/Reporter.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace penumbra::tool
{
/// How much was removed, over several surfaces.
struct DroppedPoints
{
  vtkIdType Points = 0;
  vtkIdType Cells = 0;

  /// One sentence, if anything was dropped.
  void Report(const std::string& what, Reporter& reporter) const;
};

/// False where cells begin or end outside the list of their corners: to look at them is to read beyond
/// memory. True for data without such lists, and for none.
bool HasValidCells(vtkDataObject* data);

/// The geometry without points that are NaN, infinite or beyond what floats can square, and without
/// the cells that use them. Returns the input itself where all is well.
vtkSmartPointer<vtkPolyData> DropNonFinite(vtkPolyData* geometry, DroppedPoints& dropped);
}
