// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Creates one object of every technique in the module. Generated from the list of parameter files.
 */
#pragma once

#include "vtkGITechnique.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace penumbra
{
std::vector<vtkSmartPointer<vtkGITechnique>> CreateTechniques();
}
