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
  if (this->Guarded != window)
  {
    this->Leave();
    this->SetContext(window); // joins the window's list
    this->Guarded = window;
  }
  window->MakeCurrent();
}

void vtkGIContextGuard::Leave()
{
  this->SetContext(nullptr); // leaves the list, which calls ReleaseGraphicsResources()
}

void vtkGIContextGuard::ReleaseGraphicsResources(vtkWindow* window)
{
  // VTK's windows push their context first; those that cannot, have it current or make it so.
  if (this->Guarded)
  {
    this->Guarded->MakeCurrent();
    this->Free();
    this->Guarded = nullptr;
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
