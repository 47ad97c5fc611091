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
// A derived class can name protected members of its base.
struct ViewMembers : public vtkPVRenderView
{
  static vtkPVSynchronizedRenderer* GetSynchronizedRenderer(vtkPVRenderView* view)
  {
    return view->*(&ViewMembers::SynchronizedRenderers);
  }
  static bool IsInScreenshot(vtkPVView* view)
  {
    return (view->*(&ViewMembers::GetInCaptureScreenshot))();
  }
  static vtkPVSession* GetSessionOf(vtkPVView* view)
  {
    return (view->*(&ViewMembers::GetSession))();
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

vtkPVSynchronizedRenderer* SynchronizedRendererOf(vtkPVRenderView* view)
{
  return ViewMembers::GetSynchronizedRenderer(view);
}

bool IsCaptured(vtkPVView* view)
{
  return ViewMembers::IsInScreenshot(view);
}

bool IsSingleProcess()
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetNumberOfProcesses() < 2;
}

bool IsConnected(vtkPVView* view)
{
  vtkPVSession* session = ViewMembers::GetSessionOf(view);
  return session && !session->HasProcessRole(vtkPVSession::CLIENT_AND_SERVERS);
}

bool IsClient(vtkPVView* view)
{
  vtkPVSession* session = ViewMembers::GetSessionOf(view);
  return !session || session->HasProcessRole(vtkPVSession::CLIENT);
}

// pvbatch and pvserver draw each view in a separate window that borrows the context of the process's window. Before its
// first frame that window initializes GLEW again, which looks for an X display and fails without one, although the
// process's window has already loaded all functions. Therefore the window is initialized a moment earlier, when it
// announces the frame, without GLEW.
#ifdef PENUMBRA_VTK_HAS_GLEW
namespace
{
void InitializeWithoutGlew(vtkObject* caller, unsigned long, void*, void*)
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
    command->SetCallback(InitializeWithoutGlew);
    window->AddObserver(vtkViewLayout::RequestUpdateLayoutEvent, command);
  }
#else
  (void)window;
#endif
}

namespace
{
void OnProxyRegistered(vtkObject*, unsigned long, void*, void* data)
{
  using Information = vtkSMProxyManager::RegisteredProxyInformation;
  const auto* registered = static_cast<const Information*>(data);
  const bool isProxy = registered->Type == Information::PROXY && registered->Proxy;
  auto* view =
    isProxy ? vtkPVView::SafeDownCast(registered->Proxy->GetClientSideObject()) : nullptr;
  if (view)
  {
    PrepareWindow(view->GetRenderWindow());
  }
}
}

void PrepareNewWindows()
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProxyRegistered);
  vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, command);
}
}
