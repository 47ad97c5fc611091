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
#include <utility>

namespace penumbra
{
vtkStandardNewMacro(StillFramesPass);

void StillFramesPass::SetPass(vtkGIPass* pass)
{
  this->Pass = pass;
}

namespace
{
// ParaView's desired update rate is 5 frames per second during interaction, and 0.002 for a still picture.
bool IsMoving(vtkRenderer* renderer)
{
  return renderer->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0;
}
}

void StillFramesPass::ShareBudget(vtkRenderer* renderer)
{
  if (IsMoving(renderer) && !renderer->GetSelector())
  {
    this->Pass->ShareFrameBudget(renderer, MaximumOverRanks);
  }
}

bool StillFramesPass::TakeRendered()
{
  return std::exchange(this->Rendered, false);
}

void StillFramesPass::Render(const vtkRenderState* state)
{
  this->Rendered = true;
  vtkRenderer* renderer = state->GetRenderer();
  const bool still = !IsMoving(renderer) && !renderer->GetSelector();
  const bool captured = still && this->View && IsCaptured(this->View);
  if (captured)
  {
    this->Pass->Restart();
  }
  const bool single = IsSingleProcess();
  this->Pass->SetJoinTiles(captured && single);
  this->Pass->SetStillPicture(still);
  const int frames = still ? std::max(this->Frames, 1) : 1;
  for (int i = 0; i == 0 || (i < frames && !this->Pass->GetCopiedTile()); ++i)
  {
    this->Pass->Render(state);
  }
  this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
  if (still && single && this->ReportedNotes != this->Pass->GetNotes())
  {
    this->ReportedNotes = this->Pass->GetNotes();
    if (!this->ReportedNotes.empty())
    {
      vtkOutputWindow::GetInstance()->DisplayText(
        ("Penumbra: " + this->ReportedNotes + "\n").c_str());
    }
  }
}

void StillFramesPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Pass->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
}
