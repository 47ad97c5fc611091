// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One new object of every technique the module holds. Generated from the list of parameter files.
 */
#pragma once

#include "vtkGITechnique.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace penumbra
{
std::vector<vtkSmartPointer<vtkGITechnique>> CreateTechniques();
}
