// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the plugin does when a process loads it.
 */
#pragma once

#include "vtkPenumbraParaViewModule.h" // for the export macro

namespace penumbra
{
/// ParaView takes a process without an X display for one that cannot draw, and ranks of it then wait for
/// each other for ever. Where vtkHeadlessRenderWindow draws, the question is answered for ParaView, and windows of
/// views to come are prepared.
VTKPENUMBRAPARAVIEW_EXPORT void AllowDrawingWithoutDisplay();
}
