// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewAccess.h"

#include "vtkHeadlessRenderWindow.h"

#include "vtkCallbackCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPVProcessWindow.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkViewLayout.h"

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
  static bool Captured(vtkPVView* view)
  {
    return (view->*(&ViewMembers::GetInCaptureScreenshot))();
  }
  static vtkPVSession* Session(vtkPVView* view) { return (view->*(&ViewMembers::GetSession))(); }
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

bool IsCaptured(vtkPVView* view)
{
  return ViewMembers::Captured(view);
}

bool IsAlone()
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetNumberOfProcesses() < 2;
}

bool IsConnected(vtkPVView* view)
{
  vtkPVSession* session = ViewMembers::Session(view);
  return session && !session->HasProcessRole(vtkPVSession::CLIENT_AND_SERVERS);
}

bool IsClient(vtkPVView* view)
{
  vtkPVSession* session = ViewMembers::Session(view);
  return !session || session->HasProcessRole(vtkPVSession::CLIENT);
}

// pvbatch and pvserver draw each view in a window of its own that borrows the context of the process's
// window. Before its first frame it would ask GLEW for OpenGL's functions again, which looks for an X
// display and gives up without one, although the process's window loaded every function. So all that is
// done then is done a moment earlier, when the window announces the frame, without GLEW.
#ifdef PENUMBRA_VTK_HAS_GLEW
namespace
{
void BeforeFrame(vtkObject* caller, unsigned long, void*, void*)
{
  auto* borrower = static_cast<vtkOpenGLRenderWindow*>(caller);
  auto* context = vtkHeadlessRenderWindow::SafeDownCast(vtkPVProcessWindow::GetRenderWindow());
  if (WindowMembers::IsInitialized(borrower) || !context)
  {
    return;
  }
  vtkPVProcessWindow::PrepareForRendering();
  context->MakeCurrent();
  context->GetState()->PushFramebufferBindings();
  WindowMembers::IsGlewValid(borrower) = true;
  WindowMembers::IsInitialized(borrower) = true;
  borrower->OpenGLInit();
  context->GetState()->PopFramebufferBindings();
}
}
#endif

void PrepareWindow(vtkRenderWindow* window)
{
#ifdef PENUMBRA_VTK_HAS_GLEW
  auto* borrower = vtkOpenGLRenderWindow::SafeDownCast(window);
  vtkRenderWindow* context = vtkPVProcessWindow::GetRenderWindow();
  if (borrower && borrower != context && vtkHeadlessRenderWindow::SafeDownCast(context))
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(BeforeFrame);
    window->AddObserver(vtkViewLayout::RequestUpdateLayoutEvent, command);
  }
#else
  (void)window;
#endif
}

namespace
{
void Registered(vtkObject*, unsigned long, void*, void* data)
{
  using Information = vtkSMProxyManager::RegisteredProxyInformation;
  const auto* registered = static_cast<const Information*>(data);
  const bool proxy = registered->Type == Information::PROXY && registered->Proxy;
  auto* view = proxy ? vtkPVView::SafeDownCast(registered->Proxy->GetClientSideObject()) : nullptr;
  if (view)
  {
    PrepareWindow(view->GetRenderWindow());
  }
}
}

void PrepareNewWindows()
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Registered);
  vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, command);
}
}
