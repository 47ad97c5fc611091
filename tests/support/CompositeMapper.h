// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The mapper of composite data that knows its blocks' looks in every version of VTK: the second one, until it was merged
// into the first.
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
