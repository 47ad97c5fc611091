// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewLook.h"

#include "vtkGILook.h"
#include "vtkGIPass.h"

#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkRenderer.h"

namespace penumbra
{
void ViewLook::Update(vtkRenderer* renderer, vtkGIPass* pass)
{
  if (this->Applied == this->Chosen)
  {
    vtkGILook::Restore(renderer); // the view sets its own whenever a property changes
    return;
  }
  this->Remove(renderer);
  this->Applied = this->Chosen; // one with a mistake is reported only once
  vtkNew<vtkGILook> look;
  if (look->Load(this->Chosen.c_str()))
  {
    this->Problem.clear();
    look->ApplyTo(renderer, pass);
  }
  else if (this->Problem != look->GetLastError())
  {
    this->Problem = look->GetLastError();
    vtkOutputWindow::GetInstance()->DisplayErrorText(
      ("Penumbra: " + this->Problem + ".\n").c_str());
  }
}

void ViewLook::Remove(vtkRenderer* renderer)
{
  if (!this->Applied.empty()) // or it is another's, as a view may have settings of its own and separate ones
  {
    this->Applied.clear();
    vtkGILook::RemoveFrom(renderer);
  }
}
}
