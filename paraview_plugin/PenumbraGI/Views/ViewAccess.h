// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Access to parts of ParaView's views that their public methods do not offer.
 */
#pragma once

class vtkPVRenderView;
class vtkPVSynchronizedRenderer;
class vtkPVView;
class vtkRenderWindow;

namespace penumbra
{
/// The object that sets the render passes of a view's renderer.
vtkPVSynchronizedRenderer* SynchronizedRendererOf(vtkPVRenderView* view);

/// Whether a screenshot of the view is being taken.
bool IsCaptured(vtkPVView* view);

/// Whether this process draws the whole picture; false if it is one of several ranks.
bool IsSingleProcess();

/// Whether the client and the server that may draw a view are separate processes, as with pvserver.
bool IsConnected(vtkPVView* view);

/// Whether this process shows messages to the user of a view.
bool IsClient(vtkPVView* view);

/// Prepare a view's window for drawing in the context of a process without an X display, in which GLEW fails. Does
/// nothing if that is not necessary.
void PrepareWindow(vtkRenderWindow* window);

/// Do the same for the windows of all views that are created from now on, including charts.
void PrepareNewWindows();
}
