// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewAccess.h"

#include "vtkHeadlessRenderWindow.h"

#include "vtkCallbackCommand.h"
#include "vtkCommunicator.h"
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

#include <cstring>
#include <vector>

#if __has_include("vtk_glew.h")
#define PENUMBRA_VTK_HAS_GLEW
#endif

namespace penumbra
{
namespace
{
// A derived class may access its base's protected members.
struct ViewMembers : public vtkPVRenderView
{
  static vtkPVSynchronizedRenderer* SynchronizedRenderer(vtkPVRenderView* view)
  {
    return view->*(&ViewMembers::SynchronizedRenderers);
  }
  static bool InCapture(vtkPVView* view)
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

vtkPVSynchronizedRenderer* SynchronizedRendererOf(vtkPVRenderView* view)
{
  return ViewMembers::SynchronizedRenderer(view);
}

bool IsCaptured(vtkPVView* view)
{
  return ViewMembers::InCapture(view);
}

bool IsSingleProcess()
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetNumberOfProcesses() < 2;
}

void MaximumOverRanks(double* values, int count)
{
  if (!IsSingleProcess())
  {
    const std::vector<double> own(values, values + count);
    vtkMultiProcessController::GetGlobalController()->AllReduce(
      own.data(), values, count, vtkCommunicator::MAX_OP);
  }
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

// pvbatch and pvserver draw each view in its own window, which shares the context of the process's window. Before
// its first frame, the window would initialize GLEW again, which fails without an X display although the process's
// window has loaded all functions already. So the same initialization, without GLEW, is done earlier: when the window
// announces the frame.
#ifdef PENUMBRA_VTK_HAS_GLEW
namespace
{
void InitializeWithoutGlew(vtkObject* caller, unsigned long, void*, void*)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(caller);
  auto* context = vtkHeadlessRenderWindow::SafeDownCast(vtkPVProcessWindow::GetRenderWindow());
  if (WindowMembers::IsInitialized(window) || !context)
  {
    return;
  }
  vtkPVProcessWindow::PrepareForRendering();
  context->MakeCurrent();
  context->GetState()->PushFramebufferBindings();
  WindowMembers::IsGlewValid(window) = true;
  WindowMembers::IsInitialized(window) = true;
  window->OpenGLInit();
  context->GetState()->PopFramebufferBindings();
}
}
#endif

void PrepareWindow(vtkRenderWindow* window)
{
#ifdef PENUMBRA_VTK_HAS_GLEW
  auto* sharing = vtkOpenGLRenderWindow::SafeDownCast(window);
  vtkRenderWindow* context = vtkPVProcessWindow::GetRenderWindow();
  if (sharing && sharing != context && vtkHeadlessRenderWindow::SafeDownCast(context))
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
void PrepareRegisteredView(vtkObject*, unsigned long, void*, void* data)
{
  using Information = vtkSMProxyManager::RegisteredProxyInformation;
  const auto* registered = static_cast<const Information*>(data);
  // Prototypes of views, which ParaView registers elsewhere, must not be created.
  const bool viewProxy = registered->Type == Information::PROXY && registered->Proxy &&
    registered->GroupName && std::strcmp(registered->GroupName, "views") == 0;
  auto* view =
    viewProxy ? vtkPVView::SafeDownCast(registered->Proxy->GetClientSideObject()) : nullptr;
  if (view)
  {
    PrepareWindow(view->GetRenderWindow());
  }
}
}

void PrepareNewWindows()
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(PrepareRegisteredView);
  vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, command);
}
}
