// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIRefinement.h"

#include "vtkGIPass.h"

#include "vtkCollection.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <chrono>
#include <utility>

vtkStandardNewMacro(vtkGIRefinement);

namespace
{
// Milliseconds between two frames, in which the interactor handles what the user does.
constexpr int Interval = 5;
// Frames beyond the mean's: a budget refines for a few, and what changes in every frame is never finished.
constexpr int MostOthers = 16;

using Clock = std::chrono::steady_clock;
}

class vtkGIRefinement::Internals
{
public:
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkRenderWindow> Window; ///< of the interactor
  vtkWeakPointer<vtkGIPass> Pass;
  unsigned long OnTimer = 0;
  unsigned long OnChange = 0;
  unsigned long OnFrame = 0;
  int Timer = 0; ///< 0: none
  int Fired = 0; ///< the last one that fired; 0: none
  int FramesDrawn = 0; ///< frames since the window was drawn by others
  bool IsDrawing = false;
  bool IsFiring = false; ///< the interactor is telling that a timer fires
  Clock::time_point LastOther; ///< when the window was drawn by others
};

vtkGIRefinement::vtkGIRefinement()
  : Impl(std::make_unique<Internals>())
{
}

vtkGIRefinement::~vtkGIRefinement()
{
  this->SetInteractor(nullptr);
}

void vtkGIRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Interactor: " << this->Impl->Interactor.Get() << "\n"
     << indent << "Pass: " << this->Impl->Pass.Get() << "\n"
     << indent << "Frames: " << this->Frames << "\n"
     << indent << "Pause: " << this->Pause << "\n";
}

void vtkGIRefinement::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (interactor == this->Impl->Interactor)
  {
    return;
  }
  this->Stop();
  this->Detach();
  this->ForgetFired();
  if (this->Impl->Interactor)
  {
    this->Impl->Interactor->RemoveObserver(this->Impl->OnTimer);
    this->Impl->Interactor->RemoveObserver(this->Impl->OnChange);
  }
  this->Impl->Interactor = interactor;
  if (interactor)
  {
    this->Impl->OnTimer =
      interactor->AddObserver(vtkCommand::TimerEvent, this, &vtkGIRefinement::AtTimer);
    this->Impl->OnChange =
      interactor->AddObserver(vtkCommand::AnyEvent, this, &vtkGIRefinement::FollowWindow);
    this->Attach();
  }
  this->Modified();
}

vtkRenderWindowInteractor* vtkGIRefinement::GetInteractor()
{
  return this->Impl->Interactor;
}

void vtkGIRefinement::SetPass(vtkGIPass* pass)
{
  if (pass != this->Impl->Pass)
  {
    this->Stop();
    this->Impl->Pass = pass;
    this->Modified();
  }
}

vtkGIPass* vtkGIRefinement::GetPass()
{
  return this->Impl->Pass;
}

// The interactor may get its window later, or another one, which it does not announce.
void vtkGIRefinement::FollowWindow()
{
  vtkRenderWindowInteractor* interactor = this->Impl->Interactor;
  if (interactor && interactor->GetRenderWindow() != this->Impl->Window)
  {
    this->Attach();
    this->AfterFrame();
  }
}

void vtkGIRefinement::Attach()
{
  vtkRenderWindow* window = this->Impl->Interactor->GetRenderWindow();
  this->Detach();
  this->Impl->Window = window;
  if (window)
  {
    this->Impl->OnFrame =
      window->AddObserver(vtkCommand::EndEvent, this, &vtkGIRefinement::AfterFrame);
  }
  this->Stop(); // an event of the interactor, which must find the new window
}

void vtkGIRefinement::Detach()
{
  if (this->Impl->Window)
  {
    this->Impl->Window->RemoveObserver(this->Impl->OnFrame);
    this->Impl->Window = nullptr;
  }
}

bool vtkGIRefinement::IsActive()
{
  return this->Impl->Timer != 0 && this->Impl->Interactor && this->Impl->Pass;
}

void vtkGIRefinement::Stop()
{
  const int timer = std::exchange(this->Impl->Timer, 0);
  if (timer != 0 && this->Impl->Interactor)
  {
    this->Impl->Interactor->DestroyTimer(timer);
  }
}

void vtkGIRefinement::ForgetFired()
{
  const int timer = std::exchange(this->Impl->Fired, 0);
  if (timer != 0 && this->Impl->Interactor && !this->Impl->IsFiring)
  {
    this->Impl->Interactor->DestroyTimer(timer);
  }
}

void vtkGIRefinement::Arm(int milliseconds)
{
  this->Stop();
  if (this->Impl->Interactor)
  {
    this->Impl->Timer = this->Impl->Interactor->CreateOneShotTimer(milliseconds);
  }
}

bool vtkGIRefinement::IsFinished()
{
  vtkRenderWindow* window = this->Impl->Window;
  vtkGIPass* pass = this->Impl->Pass;
  if (!window || !pass)
  {
    return true;
  }
  vtkCollectionSimpleIterator cookie;
  vtkRendererCollection* renderers = window->GetRenderers();
  renderers->InitTraversal(cookie);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(cookie))
  {
    if (renderer->GetPass() == pass && renderer->GetDraw() &&
      (pass->HasLoweredSettings(renderer) || pass->GetAccumulatedFrames(renderer) < this->Frames))
    {
      return false;
    }
  }
  return true;
}

void vtkGIRefinement::AfterFrame()
{
  this->FollowWindow(); // this may have been a window that the interactor has left
  if (this->Impl->IsDrawing)
  {
    return;
  }
  this->Impl->FramesDrawn = 0;
  this->Impl->LastOther = Clock::now();
  // While the user turns the scene, one timer is enough: it finds out that it is early.
  if (this->Impl->Timer == 0 && !this->IsFinished())
  {
    this->Arm(this->Pause);
  }
}

bool vtkGIRefinement::AtTimer(vtkObject*, unsigned long, void* timer)
{
  if (timer && this->Impl->Timer != 0 && *static_cast<int*>(timer) == this->Impl->Timer)
  {
    const vtkSmartPointer<vtkGIRefinement> alive =
      this; // an observer of the frame may let go of it
    // The interactor keeps it until it is destroyed. Older VTK (9.2 on X11) walks through its timers right now, so this one must
    // stay until the next fires.
    this->ForgetFired();
    this->Impl->Fired = std::exchange(this->Impl->Timer, 0);
    this->Impl->IsFiring = true;
    this->DrawFrame();
    // If nobody else holds this, it is deleted now, while the timer is still in use.
    this->Impl->IsFiring = this->GetReferenceCount() == 1;
  }
  return false; // others may want the event, too
}

void vtkGIRefinement::DrawFrame()
{
  if (this->IsFinished() || this->Impl->FramesDrawn >= this->Frames + MostOthers)
  {
    return;
  }
  const std::chrono::duration<double, std::milli> rest = Clock::now() - this->Impl->LastOther;
  // Some windows handle events, timers included, while they draw.
  const bool busy = this->Impl->IsDrawing || this->Impl->Window->CheckInRenderStatus();
  if (busy || rest.count() < this->Pause)
  {
    this->Arm(busy ? this->Pause : static_cast<int>(this->Pause - rest.count()) + 1);
    return;
  }
  ++this->Impl->FramesDrawn;
  this->Impl->IsDrawing = true;
  this->Impl->Interactor->Render();
  this->Impl->IsDrawing = false;
  if (!this->IsFinished() && this->Impl->FramesDrawn < this->Frames + MostOthers)
  {
    this->Arm(Interval);
  }
}
