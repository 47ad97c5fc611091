// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/ContextGuard.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGIContextGuard);

vtkGIContextGuard::~vtkGIContextGuard()
{
  this->Leave();
}

void vtkGIContextGuard::Enter(vtkOpenGLRenderWindow* window)
{
  if (this->GuardedWindow != window)
  {
    this->Leave();
    this->SetContext(window); // joins the window's list
    this->GuardedWindow = window;
  }
  window->MakeCurrent();
}

void vtkGIContextGuard::Leave()
{
  this->SetContext(nullptr); // leaves the list, which calls ReleaseGraphicsResources()
}

void vtkGIContextGuard::ReleaseGraphicsResources(vtkWindow* window)
{
  // VTK's windows push their context first. For those that cannot, the context is made current here.
  if (this->GuardedWindow)
  {
    this->GuardedWindow->MakeCurrent();
    this->FreeObjects();
    this->GuardedWindow = nullptr;
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
