// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The two places where the plugin reaches into ParaView's views further than their public methods do.
 */
#pragma once

class vtkPVRenderView;
class vtkPVSynchronizedRenderer;
class vtkRenderWindow;

namespace penumbra
{
/// What makes the passes of a view's renderer.
vtkPVSynchronizedRenderer* PassesOf(vtkPVRenderView* view);

/// Makes a view's window ready to draw in the context of a process that has no X display, which GLEW
/// refuses; does nothing where the window needs no help.
void PrepareWindow(vtkRenderWindow* window);
}
