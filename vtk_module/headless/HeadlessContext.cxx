// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

#include "headless/HeadlessContext.h"

#include <cstdio>
#include <dlfcn.h>

namespace penumbra
{
namespace
{
// Our context that was last made current in this thread. It may no longer be current: IsCurrent() asks the library.
thread_local std::weak_ptr<HeadlessContext> CurrentContext;

// The EGL and GLX functions that release and restore a context that is not ours.
// They are looked up only in libraries that the process has loaded: without the library
// there can be no such context.
struct ForeignEGL
{
  void* (*GetCurrentContext)() = nullptr;
  void* (*GetCurrentDisplay)() = nullptr;
  void* (*GetCurrentSurface)(int) = nullptr;
  unsigned (*MakeCurrent)(void*, void*, void*, void*) = nullptr;
  static constexpr int DrawSurface = 0x3059; // EGL_DRAW
  static constexpr int ReadSurface = 0x305A; // EGL_READ

  bool Load()
  {
    void* library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (!library)
    {
      return false;
    }
    this->GetCurrentContext =
      reinterpret_cast<void* (*)()>(dlsym(library, "eglGetCurrentContext"));
    this->GetCurrentDisplay =
      reinterpret_cast<void* (*)()>(dlsym(library, "eglGetCurrentDisplay"));
    this->GetCurrentSurface =
      reinterpret_cast<void* (*)(int)>(dlsym(library, "eglGetCurrentSurface"));
    this->MakeCurrent = reinterpret_cast<unsigned (*)(void*, void*, void*, void*)>(
      dlsym(library, "eglMakeCurrent"));
    dlclose(library); // RTLD_NOLOAD added a reference
    return this->GetCurrentContext && this->GetCurrentDisplay && this->GetCurrentSurface &&
      this->MakeCurrent;
  }
};

struct ForeignGLX
{
  void* (*GetCurrentContext)() = nullptr;
  void* (*GetCurrentDisplay)() = nullptr;
  unsigned long (*GetCurrentDrawable)() = nullptr;
  unsigned long (*GetCurrentReadDrawable)() = nullptr;
  int (*MakeContextCurrent)(void*, unsigned long, unsigned long, void*) = nullptr;

  bool Load()
  {
    void* library = dlopen("libGL.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (!library)
    {
      return false;
    }
    this->GetCurrentContext =
      reinterpret_cast<void* (*)()>(dlsym(library, "glXGetCurrentContext"));
    this->GetCurrentDisplay =
      reinterpret_cast<void* (*)()>(dlsym(library, "glXGetCurrentDisplay"));
    this->GetCurrentDrawable =
      reinterpret_cast<unsigned long (*)()>(dlsym(library, "glXGetCurrentDrawable"));
    this->GetCurrentReadDrawable =
      reinterpret_cast<unsigned long (*)()>(dlsym(library, "glXGetCurrentReadDrawable"));
    this->MakeContextCurrent =
      reinterpret_cast<int (*)(void*, unsigned long, unsigned long, void*)>(
        dlsym(library, "glXMakeContextCurrent"));
    dlclose(library);
    return this->GetCurrentContext && this->GetCurrentDisplay && this->GetCurrentDrawable &&
      this->GetCurrentReadDrawable && this->MakeContextCurrent;
  }
};

void ReleaseForeign()
{
  ForeignEGL egl;
  if (egl.Load() && egl.GetCurrentContext())
  {
    egl.MakeCurrent(egl.GetCurrentDisplay(), nullptr, nullptr, nullptr);
    return;
  }
  ForeignGLX glx;
  if (glx.Load() && glx.GetCurrentContext())
  {
    glx.MakeContextCurrent(glx.GetCurrentDisplay(), 0, 0, nullptr);
  }
}
}

HeadlessContext::~HeadlessContext() = default;

bool HeadlessContext::MakeCurrent()
{
  if (this->IsCurrent())
  {
    return true;
  }
  // EGL, GLX and OSMesa each reject, or misinterpret, the thread state of another one. The current context
  // must therefore be released by the library that owns it.
  const std::shared_ptr<HeadlessContext> previous = CurrentContext.lock();
  if (previous && previous->IsCurrent())
  {
    previous->Release();
  }
  else
  {
    ReleaseForeign();
  }
  if (!this->Bind())
  {
    return false;
  }
  CurrentContext = this->weak_from_this();
  return true;
}

void HeadlessContext::Release()
{
  if (this->IsCurrent())
  {
    this->Unbind();
    CurrentContext.reset();
  }
}

SavedContext SavedContext::Capture()
{
  SavedContext saved;
  const std::shared_ptr<HeadlessContext> own = CurrentContext.lock();
  if (own && own->IsCurrent())
  {
    saved.Source = Owner::Penumbra;
    saved.OwnContext = own;
    return saved;
  }
  ForeignEGL egl;
  if (egl.Load() && egl.GetCurrentContext())
  {
    saved.Source = Owner::ForeignEGL;
    saved.Display = egl.GetCurrentDisplay();
    saved.Context = egl.GetCurrentContext();
    saved.Draw = egl.GetCurrentSurface(ForeignEGL::DrawSurface);
    saved.Read = egl.GetCurrentSurface(ForeignEGL::ReadSurface);
    return saved;
  }
  ForeignGLX glx;
  if (glx.Load() && glx.GetCurrentContext())
  {
    saved.Source = Owner::ForeignGLX;
    saved.Display = glx.GetCurrentDisplay();
    saved.Context = glx.GetCurrentContext();
    saved.Draw = reinterpret_cast<void*>(glx.GetCurrentDrawable());
    saved.Read = reinterpret_cast<void*>(glx.GetCurrentReadDrawable());
  }
  return saved;
}

void SavedContext::Restore() const
{
  if (this->Source == Owner::Nobody)
  {
    return;
  }
  if (this->Source == Owner::Penumbra)
  {
    if (const std::shared_ptr<HeadlessContext> own = this->OwnContext.lock())
    {
      own->MakeCurrent();
    }
    return;
  }
  if (const std::shared_ptr<HeadlessContext> own = CurrentContext.lock())
  {
    own->Release();
  }
  ForeignEGL egl;
  ForeignGLX glx;
  if (this->Source == Owner::ForeignEGL && egl.Load())
  {
    egl.MakeCurrent(this->Display, this->Draw, this->Read, this->Context);
  }
  else if (this->Source == Owner::ForeignGLX && glx.Load())
  {
    glx.MakeContextCurrent(this->Display, reinterpret_cast<unsigned long>(this->Draw),
      reinterpret_cast<unsigned long>(this->Read), this->Context);
  }
}

void* OpenLibrary(std::initializer_list<const char*> names, std::string& reason)
{
  for (const char* name : names)
  {
    // RTLD_LOCAL, as OSMesa exports all gl functions and must not shadow the system's.
    if (void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL))
    {
      return library;
    }
    const char* text = dlerror();
    // The first name is the one to install, so report its reason.
    if (reason.empty())
    {
      reason = text ? text : name;
    }
  }
  return nullptr;
}

std::string ToString(GLVersion version)
{
  return std::to_string(version.Major) + "." + std::to_string(version.Minor);
}

GLVersion ParseGLVersion(const char* text)
{
  GLVersion version{ 0, 0 };
  if (text)
  {
    std::sscanf(text, "%d.%d", &version.Major, &version.Minor);
  }
  return version;
}
}
