// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StillFramesPass.h"

#include "ViewAccess.h"

#include "vtkGIPass.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPVView.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace penumbra
{
vtkStandardNewMacro(StillFramesPass);

void StillFramesPass::SetPass(vtkGIPass* pass)
{
  this->Pass = pass;
}

void StillFramesPass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  // ParaView asks for 5 frames a second while it interacts, and for 0.002 of a still picture.
  const bool still =
    renderer->GetRenderWindow()->GetDesiredUpdateRate() < 1.0 && !renderer->GetSelector();
  const bool captured = still && this->View && IsCaptured(this->View);
  if (captured)
  {
    this->Pass->Restart();
  }
  const bool alone = IsAlone();
  this->Pass->SetJoinTiles(captured && alone);
  const int frames = still ? std::max(this->Frames, 1) : 1;
  for (int i = 0; i == 0 || (i < frames && !this->Pass->GetCopiedTile()); ++i)
  {
    this->Pass->Render(state);
  }
  this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
  if (still && alone && this->Told != this->Pass->GetNotes())
  {
    this->Told = this->Pass->GetNotes();
    if (!this->Told.empty())
    {
      vtkOutputWindow::GetInstance()->DisplayText(("Penumbra: " + this->Told + "\n").c_str());
    }
  }
}

void StillFramesPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Pass->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
}
