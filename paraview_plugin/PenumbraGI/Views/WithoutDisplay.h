// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Initialization of the plugin when a process loads it.
 */
#pragma once

#include "vtkPenumbraParaViewModule.h" // for the export macro

namespace penumbra
{
/// Let ParaView draw without an X display where vtkHeadlessRenderWindow can. ParaView assumes that a process without
/// an X display cannot draw, and its ranks then wait for each other for ever. This turns off ParaView's test and
/// prepares the windows of all views created later.
VTKPENUMBRAPARAVIEW_EXPORT void AllowDrawingWithoutDisplay();
}
