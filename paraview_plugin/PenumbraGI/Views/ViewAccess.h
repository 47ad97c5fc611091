// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Access to parts of ParaView's views that have no public methods.
 */
#pragma once

class vtkPVRenderView;
class vtkPVSynchronizedRenderer;
class vtkPVView;
class vtkRenderWindow;

namespace penumbra
{
/// The object that sets up the render passes of a view.
vtkPVSynchronizedRenderer* SynchronizedRendererOf(vtkPVRenderView* view);

/// Whether a screenshot of the view is being taken.
bool IsCaptured(vtkPVView* view);

/// Whether this process draws the whole picture: false for one of several ranks.
bool IsSingleProcess();

/// Replace values by their maximum over all ranks, which must all call it.
void MaximumOverRanks(double* values, int count);

/// Whether the client and the server that may draw the view are separate processes, as with pvserver.
bool IsConnected(vtkPVView* view);

/// Whether this process is the client, which shows messages to the user.
bool IsClient(vtkPVView* view);

/// Prepare a view's window to draw in the context of a process without an X display, where GLEW fails. Does nothing
/// to other windows.
void PrepareWindow(vtkRenderWindow* window);

/// Prepare the windows of all views created later, including charts.
void PrepareNewWindows();
}
