// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewAccess.h"

#include "vtkHeadlessRenderWindow.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPVProcessWindow.h"
#include "vtkPVRenderView.h"

#if __has_include("vtk_glew.h")
#define PENUMBRA_VTK_HAS_GLEW
#endif

namespace penumbra
{
namespace
{
// A derived class may name its base's protected members.
struct ViewMembers : public vtkPVRenderView
{
  static vtkPVSynchronizedRenderer* Passes(vtkPVRenderView* view)
  {
    return view->*(&ViewMembers::SynchronizedRenderers);
  }
};

#ifdef PENUMBRA_VTK_HAS_GLEW
struct WindowMembers : public vtkOpenGLRenderWindow
{
  static bool& IsInitialized(vtkOpenGLRenderWindow* window)
  {
    return window->*(&WindowMembers::Initialized);
  }
  static bool& IsGlewValid(vtkOpenGLRenderWindow* window)
  {
    return window->*(&WindowMembers::GlewInitValid);
  }
};
#endif
}

vtkPVSynchronizedRenderer* PassesOf(vtkPVRenderView* view)
{
  return ViewMembers::Passes(view);
}

// pvbatch and pvserver draw each view in a window of its own that borrows the context of the process's
// window. It would ask GLEW for OpenGL's functions again, which looks for an X display and gives up
// without one, although the process's window loaded every function. So it is told that this is done.
void PrepareWindow(vtkRenderWindow* window)
{
#ifdef PENUMBRA_VTK_HAS_GLEW
  auto* borrower = vtkOpenGLRenderWindow::SafeDownCast(window);
  auto* context = vtkHeadlessRenderWindow::SafeDownCast(vtkPVProcessWindow::GetRenderWindow());
  if (!borrower || !context || borrower == context || WindowMembers::IsInitialized(borrower))
  {
    return;
  }
  vtkPVProcessWindow::PrepareForRendering();
  context->MakeCurrent();
  WindowMembers::IsGlewValid(borrower) = true;
  WindowMembers::IsInitialized(borrower) = true;
  borrower->OpenGLInit();
#else
  (void)window;
#endif
}
}
