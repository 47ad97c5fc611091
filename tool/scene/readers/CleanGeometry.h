// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Removes points and cells that cannot be drawn.
#pragma once

#include "common/Reporter.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace penumbra::tool
{
/// Number of removed points and cells of several surfaces.
struct DroppedPoints
{
  vtkIdType Points = 0;
  vtkIdType Cells = 0;

  /// Prints a note if anything was removed.
  void Report(const std::string& what, Reporter& reporter) const;
};

/// Whether cells lie within their list of corners; otherwise any access to them reads beyond memory. True for data without
/// such lists, and for null.
bool HasValidCells(vtkDataObject* data);

/// The geometry without points that are NaN, infinite or too large to be squared in floats, and without the cells that use
/// them. Returns the input if nothing is removed.
vtkSmartPointer<vtkPolyData> DropNonFinite(vtkPolyData* geometry, DroppedPoints& dropped);
}
