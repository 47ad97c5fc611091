// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIRefinement
 * @brief   goes on drawing a picture at rest until it is finished
 *
 * A picture of vtkGIPass becomes better while nothing changes: a frame budget gives the techniques their own settings back,
 * and averages over frames lose their noise. Programs that draw only when something changes stop after the first frame. This
 * class draws the others, by timers of the window's interactor, so that the user is not kept waiting:
 *
 * @code
 * vtkNew<vtkGIRefinement> refinement;
 * refinement->SetInteractor(interactor);
 * refinement->SetPass(gi);
 * @endcode
 *
 * It begins when the window was drawn by anyone else, and again whenever that happens. It stops when each renderer that has the
 * pass shows a mean of the wanted number of frames with the techniques' own settings. It keeps neither the interactor nor the
 * pass alive.
 *
 * @sa vtkGIPass
 */
#ifndef vtkGIRefinement_h
#define vtkGIRefinement_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

#include <memory> // for the implementation

class vtkGIPass;
class vtkRenderWindowInteractor;

class VTKRENDERINGGI_EXPORT vtkGIRefinement : public vtkObject
{
public:
  static vtkGIRefinement* New();
  vtkTypeMacro(vtkGIRefinement, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The interactor whose window is drawn, and whose timers are used. nullptr stops it. If the interactor gets another
   * window, that is noticed with its next event.
   */
  void SetInteractor(vtkRenderWindowInteractor* interactor);
  vtkRenderWindowInteractor* GetInteractor();
  ///@}

  ///@{
  /**
   * The pass whose pictures are refined, in all renderers of the window that have it. nullptr stops it.
   */
  void SetPass(vtkGIPass* pass);
  vtkGIPass* GetPass();
  ///@}

  ///@{
  /**
   * Number of frames in the mean that is the finished picture. Default: 64, which takes most of the noise away.
   */
  vtkSetClampMacro(Frames, int, 1, 1 << 24);
  vtkGetMacro(Frames, int);
  ///@}

  ///@{
  /**
   * Milliseconds to wait after the window was drawn by others, so that it does not come between two frames of a
   * movement. Default: 160, a little more than the time after which a frame budget takes a picture for a still one.
   */
  vtkSetClampMacro(Pause, int, 1, 10000);
  vtkGetMacro(Pause, int);
  ///@}

  /**
   * Whether there are frames to come.
   */
  bool IsActive();

  /**
   * Draw no more frames until the window is drawn by others.
   */
  void Stop();

protected:
  vtkGIRefinement();
  ~vtkGIRefinement() override;

private:
  vtkGIRefinement(const vtkGIRefinement&) = delete;
  void operator=(const vtkGIRefinement&) = delete;

  void FollowWindow();
  void Attach();
  void Detach();
  void AfterFrame();
  bool AtTimer(vtkObject* caller, unsigned long event, void* timer);
  void DrawFrame();
  bool IsFinished();
  void Arm(int milliseconds);
  void ForgetFired();

  class Internals;
  std::unique_ptr<Internals> Impl;
  int Frames = 64;
  int Pause = 160;
};

#endif
