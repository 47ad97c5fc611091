// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The places where the plugin reaches into ParaView's views further than their public methods do.
 */
#pragma once

class vtkPVRenderView;
class vtkPVSynchronizedRenderer;
class vtkPVView;
class vtkRenderWindow;

namespace penumbra
{
/// What makes the passes of a view's renderer.
vtkPVSynchronizedRenderer* PassesOf(vtkPVRenderView* view);

/// Whether a screenshot of the view is being taken.
bool IsCaptured(vtkPVView* view);

/// Whether this process draws all of the picture: false for one of several ranks.
bool IsAlone();

/// Whether the client and what may draw a view are processes of their own, as with pvserver.
bool IsConnected(vtkPVView* view);

/// Whether this process is the one that speaks to the user of a view.
bool IsClient(vtkPVView* view);

/// Makes a view's window ready to draw in the context of a process that has no X display, which GLEW
/// refuses; does nothing where the window needs no help.
void PrepareWindow(vtkRenderWindow* window);

/// The same for the window of every view that is made from now on, charts for instance.
void PrepareNewWindows();
}
