// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The mapper of composite data that supports properties per block in every version of VTK:
// vtkCompositePolyDataMapper2, until it was merged into vtkCompositePolyDataMapper.
#if __has_include("vtkCompositePolyDataMapper2.h")
#include "vtkCompositePolyDataMapper2.h"
namespace penumbra_test
{
using CompositeMapper = vtkCompositePolyDataMapper2;
}
#else
#include "vtkCompositePolyDataMapper.h"
namespace penumbra_test
{
using CompositeMapper = vtkCompositePolyDataMapper;
}
#endif
