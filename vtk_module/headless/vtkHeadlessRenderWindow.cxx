// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHeadlessRenderWindow.h"

#include "gpu/GL.h"
#include "headless/EGLContext.h"
#include "headless/HeadlessChoice.h"
#include "headless/HeadlessContext.h"
#include "headless/HeadlessFactory.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkRect.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

using penumbra::BackendWish;

//------------------------------------------------------------------------------
struct vtkHeadlessRenderWindow::Internals
{
  std::shared_ptr<penumbra::HeadlessContext> Context;
  std::vector<penumbra::SavedContext> Stack;
  // VTK's OpenGL functions do not reach the context, so do not try again.
  bool Unreachable = false;
};

vtkStandardNewMacro(vtkHeadlessRenderWindow);

//------------------------------------------------------------------------------
vtkHeadlessRenderWindow::vtkHeadlessRenderWindow()
  : Internal(new Internals)
{
  this->DeviceIndex = -1;
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  // The picture stays in VTK's framebuffers, as there is no window to copy it to.
  this->FrameBlitMode = NoBlit;
  // The size that VTK's own windows report if there is no screen.
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
}

//------------------------------------------------------------------------------
vtkHeadlessRenderWindow::~vtkHeadlessRenderWindow()
{
  this->Finalize();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::SetBackend(int backend)
{
  backend = std::clamp(backend, static_cast<int>(AUTO), static_cast<int>(OSMESA));
  if (backend != this->Backend)
  {
    this->Finalize();
    this->Backend = backend;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::SetDeviceIndex(int index)
{
  index = std::max(index, -1);
  if (index != this->DeviceIndex)
  {
    this->Finalize();
    this->DeviceIndex = index;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::GetNumberOfDevices()
{
  return penumbra::CountEGLDevices();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::SetAutomatic(bool automatic)
{
  penumbra::SetHeadlessFactory(automatic);
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::GetAutomatic()
{
  return penumbra::HasHeadlessFactory();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::ReportContextError(const std::string& text)
{
  this->ContextError = text;
  vtkErrorMacro(<< text);
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::CreateContext()
{
  const BackendWish wish = this->Backend == EGL ? BackendWish::EGL
    : this->Backend == OSMESA                   ? BackendWish::OSMesa
                                                : BackendWish::None;
  std::string error;
  this->Internal->Context = penumbra::ChooseContext(wish, this->DeviceIndex, error);
  if (!this->Internal->Context)
  {
    this->ReportContextError(error);
  }
  return this->Internal->Context != nullptr;
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::EnsureContext()
{
  auto& context = this->Internal->Context;
  if (!context)
  {
    // Report the error once: try again only after Finalize() or a change of settings.
    if (!this->ContextError.empty() || !this->CreateContext())
    {
      return false;
    }
  }
  if (!context->MakeCurrent())
  {
    if (this->ContextError.empty())
    {
      this->ReportContextError(std::string("The OpenGL context of ") + context->GetBackendName() +
        " cannot be made current in this thread; render from the thread where it is current, or "
        "call ReleaseCurrent() there first.");
    }
    return false;
  }
  if (!this->Initialized && !this->Internal->Unreachable)
  {
    this->OpenGLInit();
    this->Internal->Unreachable = !this->Initialized;
  }
  if (this->Initialized)
  {
    this->ContextError.clear();
  }
  return this->Initialized;
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Initialize()
{
  this->EnsureContext();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Finalize()
{
  auto& context = this->Internal->Context;
  if (context)
  {
    // This makes the context current, as names of GL objects mean nothing, or something else, in another context.
    this->ReleaseGraphicsResources(this);
    context.reset();
  }
  this->Internal->Unreachable = false;
  this->ContextError.clear();
  this->Description.clear();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::OpenGLInit()
{
  // The window owns its context. There is no state of another user to save and restore, as
  // vtkGenericOpenGLRenderWindow does, and VTK's initial state can stay in effect.
  this->MakeCurrent();
  if (!this->Internal->Context || !this->IsCurrent())
  {
    return;
  }
  this->vtkOpenGLRenderWindow::OpenGLInit();
  if (this->Initialized)
  {
    // VTK assumes a double-buffered default framebuffer. Read this one's actual buffers.
    this->GetState()->ResetFramebufferBindings();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::OpenGLInitContext()
{
  if (!this->Internal->Context)
  {
    return;
  }
#ifdef GLEW_OK
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  // GLEW loads OpenGL's functions, then GLX's, and returns an error if there is no X display.
  // By then the functions that matter are loaded.
  const GLenum result = glewInit();
#ifdef GLEW_ERROR_NO_GLX_DISPLAY
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
#else
  this->GlewInitValid = result == GLEW_OK;
#endif
  if (!this->GlewInitValid)
  {
    this->ReportContextError(std::string("VTK's OpenGL library does not reach the context of ") +
      this->Internal->Context->GetBackendName() + " (GLEW: " +
      reinterpret_cast<const char*>(glewGetErrorString(result)) +
      "); install libglvnd's libGL (libgl1), or choose another backend.");
    return;
  }
  this->Initialized = true;

  GLfloat range[2] = { 1.0f, 1.0f };
  glGetFloatv(this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = glGetError() == GL_NO_ERROR ? range[1] : 1.0f;
#else
  // glad gets addresses from the window; VTK does the rest.
  this->SetOpenGLSymbolLoader(
    [](void* self, const char* name) -> VTKOpenGLAPIProc
    {
      auto* window = static_cast<vtkHeadlessRenderWindow*>(self);
      return window->Internal->Context ? window->Internal->Context->GetProcAddress(name) : nullptr;
    },
    this);
  this->vtkOpenGLRenderWindow::OpenGLInitContext();
  if (!this->Initialized)
  {
    this->ReportContextError(std::string("VTK's OpenGL loader found no functions in the context of ") +
      this->Internal->Context->GetBackendName() + "; choose another backend.");
  }
#endif
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::MakeCurrent()
{
  if (this->Internal->Context)
  {
    this->Internal->Context->MakeCurrent();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::ReleaseCurrent()
{
  if (this->Internal->Context)
  {
    this->Internal->Context->Release();
  }
}

//------------------------------------------------------------------------------
bool vtkHeadlessRenderWindow::IsCurrent()
{
  return this->Internal->Context && this->Internal->Context->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PushContext()
{
  this->Internal->Stack.push_back(penumbra::SavedContext::Capture());
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PopContext()
{
  if (!this->Internal->Stack.empty())
  {
    const penumbra::SavedContext saved = this->Internal->Stack.back();
    this->Internal->Stack.pop_back();
    saved.Restore();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Render()
{
  // As in OpenGLInit(), skip vtkGenericOpenGLRenderWindow's saving and restoring of state, which would
  // also make VTK start from OpenGL's defaults instead of its own.
  if (this->ReadyForRendering && this->EnsureContext())
  {
    this->vtkOpenGLRenderWindow::Render();
  }
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkHeadlessRenderWindow::MakeRenderWindowInteractor()
{
  this->SetInteractor(nullptr);
  this->Interactor = vtkGenericRenderWindowInteractor::New();
  this->Interactor->SetRenderWindow(this);
  return this->Interactor;
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (interactor && interactor->IsA("vtkXRenderWindowInteractor"))
  {
    vtkErrorMacro("A vtkXRenderWindowInteractor cannot serve a window without X; use a "
                  "vtkGenericRenderWindowInteractor.");
    return;
  }
  this->Superclass::SetInteractor(interactor);
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Start()
{
  if (this->EnsureContext())
  {
    this->Superclass::Start();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::End()
{
  if (this->Initialized)
  {
    this->Superclass::End();
  }
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::Frame()
{
  if (!this->Initialized)
  {
    return;
  }
  this->MakeCurrent();
  this->Superclass::Frame();
  // Start the driver's work, as no swap of buffers does so.
  glFlush();
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::SupportsOpenGL()
{
  const bool supported = this->EnsureContext();
  this->OpenGLSupportTested = true;
  this->OpenGLSupportResult = supported ? 1 : 0;
  this->OpenGLSupportMessage = supported ? this->GetDescription() : this->ContextError;
  return this->OpenGLSupportResult;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkHeadlessRenderWindow::IsDirect()
{
  return this->EnsureContext();
}

//------------------------------------------------------------------------------
const char* vtkHeadlessRenderWindow::ReportCapabilities()
{
  return this->EnsureContext() ? this->Superclass::ReportCapabilities() : this->GetContextError();
}

//------------------------------------------------------------------------------
const char* vtkHeadlessRenderWindow::GetBackendName()
{
  return this->EnsureContext() ? this->Internal->Context->GetBackendName() : "";
}

//------------------------------------------------------------------------------
const char* vtkHeadlessRenderWindow::GetDescription()
{
  if (this->EnsureContext() && this->Description.empty())
  {
    const auto text = [](GLenum name) {
      const GLubyte* value = glGetString(name);
      return std::string(value ? reinterpret_cast<const char*>(value) : "unknown");
    };
    this->Description = std::string(this->Internal->Context->GetBackendName()) + ": " +
      text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
  }
  return this->Description.c_str();
}

//------------------------------------------------------------------------------
namespace
{
// Binds the framebuffer that the window draws to within a scope. VTK queries the sizes of the bound framebuffer, and a
// surfaceless context has no default one.
class ScopedDrawFramebuffer
{
public:
  ScopedDrawFramebuffer(vtkOpenGLState* state, vtkOpenGLFramebufferObject* buffers)
    : State(state)
  {
    state->PushDrawFramebufferBinding();
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, buffers->GetFBOIndex());
  }
  ~ScopedDrawFramebuffer() { this->State->PopDrawFramebufferBinding(); }
  ScopedDrawFramebuffer(const ScopedDrawFramebuffer&) = delete;
  ScopedDrawFramebuffer& operator=(const ScopedDrawFramebuffer&) = delete;

private:
  vtkOpenGLState* State;
};
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::GetColorBufferSizes(int* rgba)
{
  if (rgba && !this->EnsureContext())
  {
    std::fill(rgba, rgba + 4, 0);
    return 0;
  }
  const ScopedDrawFramebuffer scope(this->GetState(), this->RenderFramebuffer);
  return this->Superclass::GetColorBufferSizes(rgba);
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::GetDepthBufferSize()
{
  if (!this->Initialized || !this->EnsureContext() || this->RenderFramebuffer->GetFBOIndex() == 0)
  {
    return 24; // VTK's value before there are buffers
  }
  const ScopedDrawFramebuffer scope(this->GetState(), this->RenderFramebuffer);
  return this->Superclass::GetDepthBufferSize();
}

//------------------------------------------------------------------------------
void* vtkHeadlessRenderWindow::GetGenericContext()
{
  return this->Internal->Context ? this->Internal->Context->GetNativeContext() : nullptr;
}

//------------------------------------------------------------------------------
void* vtkHeadlessRenderWindow::GetGenericDisplayId()
{
  return this->Internal->Context ? this->Internal->Context->GetNativeDisplay() : nullptr;
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  // Without a context there is nothing to read. The error has been reported already.
  if (!this->Initialized)
  {
    return VTK_ERROR;
  }
  return this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right);
}

//------------------------------------------------------------------------------
int vtkHeadlessRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  if (!this->Initialized)
  {
    const int count = (std::abs(x2 - x1) + 1) * (std::abs(y2 - y1) + 1);
    std::fill(z, z + count, 1.0f);
    return VTK_ERROR;
  }
  return this->Superclass::GetZbufferData(x1, y1, x2, y2, z);
}

//------------------------------------------------------------------------------
void vtkHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const names[] = { "auto", "EGL", "OSMesa" };
  os << indent << "Backend: " << names[this->Backend] << "\n";
  os << indent << "DeviceIndex: " << this->DeviceIndex << "\n";
  os << indent << "Description: " << this->Description << "\n";
  os << indent << "ContextError: " << this->ContextError << "\n";
}

//------------------------------------------------------------------------------
// Loading the library enables the automatic choice.
namespace
{
const bool AutomaticAtLoad = (vtkHeadlessRenderWindow::EnableAutomatic(), true);
}
