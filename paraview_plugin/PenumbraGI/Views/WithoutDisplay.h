// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Initialization of the plugin when a process loads it.
 */
#pragma once

#include "vtkPenumbraParaViewModule.h" // for the export macro

namespace penumbra
{
/// ParaView assumes that a process without an X display cannot draw, and its ranks then wait for each other forever. If
/// vtkHeadlessRenderWindow can draw, skip ParaView's test of the display, and prepare the windows of future views.
VTKPENUMBRAPARAVIEW_EXPORT void AllowDrawingWithoutDisplay();
}
