// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

#include "headless/OSMesaContext.h"

#include <array>
#include <dlfcn.h>

namespace penumbra
{
namespace
{
// From Mesa's GL/osmesa.h, whose package is rarely installed. The numbers are the library's ABI.
constexpr int OSMESA_FORMAT = 0x22;
constexpr int OSMESA_DEPTH_BITS = 0x30;
constexpr int OSMESA_STENCIL_BITS = 0x31;
constexpr int OSMESA_ACCUM_BITS = 0x32;
constexpr int OSMESA_PROFILE = 0x33;
constexpr int OSMESA_CORE_PROFILE = 0x34;
constexpr int OSMESA_CONTEXT_MAJOR_VERSION = 0x36;
constexpr int OSMESA_CONTEXT_MINOR_VERSION = 0x37;
constexpr int RGBA = 0x1908;             // GL_RGBA
constexpr unsigned UNSIGNED_BYTE = 0x1401; // GL_UNSIGNED_BYTE
constexpr unsigned VERSION = 0x1F02;     // GL_VERSION

using OSMesaHandle = void*;
using Proc = HeadlessContext::Proc;

// libglvnd's dispatch ABI, version 1 (GLdispatch.h of libglvnd). Programs linked with libGL call
// into it, and calls reach a context only if it was made current through it. OSMesa is not a glvnd vendor
// and does not do that, so it is done here.
struct DispatchThreadState
{
  int Tag;
  void (*ThreadDestroyed)(DispatchThreadState*);
  void* Private;
};
constexpr int DispatchABI = 1;
// GLX is 0 and EGL 1. With a different tag, both report that another API is current instead of
// interpreting this state as their own.
constexpr int OSMesaTag = 0x4F53;

void* LookUp(const char* name, void* getProcAddress)
{
  return reinterpret_cast<void*>(
    reinterpret_cast<Proc (*)(const char*)>(getProcAddress)(name));
}

void IgnoreThreadEnd(DispatchThreadState*) {}

// Both libraries and a dispatch table, loaded once and never unloaded, as other
// contexts and VTK's loader hold addresses in them.
struct Library
{
  OSMesaHandle (*CreateContextAttribs)(const int*, OSMesaHandle) = nullptr;
  void (*DestroyContext)(OSMesaHandle) = nullptr;
  unsigned char (*MakeCurrent)(OSMesaHandle, void*, unsigned, int, int) = nullptr;
  OSMesaHandle (*GetCurrentContext)() = nullptr;
  Proc (*GetProcAddress)(const char*) = nullptr;

  void (*DispatchInit)() = nullptr;
  int (*DispatchGetABIVersion)() = nullptr;
  int (*DispatchNewVendorID)() = nullptr;
  void* (*DispatchCreateTable)(void* (*)(const char*, void*), void*) = nullptr;
  unsigned char (*DispatchMakeCurrent)(DispatchThreadState*, void*, int, const void*) = nullptr;
  void (*DispatchLoseCurrent)() = nullptr;
  DispatchThreadState* (*DispatchGetCurrentThreadState)() = nullptr;
  Proc (*DispatchGetProcAddress)(const char*) = nullptr;
  void (*DispatchCheckMultithreaded)() = nullptr;

  void* Table = nullptr;
  int VendorID = 0;
  ContextError Error;

  Library() { this->Load(); }
  bool IsUsable() const { return this->Error.Cause.empty(); }

  static const Library& Get()
  {
    static const Library library;
    return library;
  }

private:
  template <typename Function>
  static bool Find(void* library, const char* name, Function& function)
  {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
  }

  void Load()
  {
    std::string reason;
    void* mesa = OpenLibrary({ "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" }, reason);
    if (!mesa)
    {
      this->Error = { "OSMesa could not be loaded (" + reason + ")",
        "install libosmesa6, or use EGL where the distribution has none (Mesa after 25.0)" };
      return;
    }
    if (!(Find(mesa, "OSMesaCreateContextAttribs", this->CreateContextAttribs) &&
          Find(mesa, "OSMesaDestroyContext", this->DestroyContext) &&
          Find(mesa, "OSMesaMakeCurrent", this->MakeCurrent) &&
          Find(mesa, "OSMesaGetCurrentContext", this->GetCurrentContext) &&
          Find(mesa, "OSMesaGetProcAddress", this->GetProcAddress)))
    {
      this->Error = { "the installed libOSMesa cannot make core profile contexts",
        "install Mesa 12 or later" };
      return;
    }
    reason.clear();
    void* dispatch = OpenLibrary({ "libGLdispatch.so.0" }, reason);
    if (!dispatch)
    {
      this->Error = { "OSMesa needs libglvnd's dispatch library (" + reason + ")",
        "install libglvnd0" };
      return;
    }
    if (!(Find(dispatch, "__glDispatchInit", this->DispatchInit) &&
          Find(dispatch, "__glDispatchGetABIVersion", this->DispatchGetABIVersion) &&
          Find(dispatch, "__glDispatchNewVendorID", this->DispatchNewVendorID) &&
          Find(dispatch, "__glDispatchCreateTable", this->DispatchCreateTable) &&
          Find(dispatch, "__glDispatchMakeCurrent", this->DispatchMakeCurrent) &&
          Find(dispatch, "__glDispatchLoseCurrent", this->DispatchLoseCurrent) &&
          Find(dispatch, "__glDispatchGetCurrentThreadState",
            this->DispatchGetCurrentThreadState) &&
          Find(dispatch, "__glDispatchGetProcAddress", this->DispatchGetProcAddress) &&
          Find(dispatch, "__glDispatchCheckMultithreaded", this->DispatchCheckMultithreaded)) ||
      this->DispatchGetABIVersion() != DispatchABI)
    {
      this->Error = { "libGLdispatch.so.0 has another interface than OSMesa can be joined to",
        "choose the backend egl" };
      return;
    }
    this->DispatchInit();
    this->VendorID = this->DispatchNewVendorID();
    this->Table =
      this->DispatchCreateTable(LookUp, reinterpret_cast<void*>(this->GetProcAddress));
  }
};

class OSMesaHeadlessContext final : public HeadlessContext
{
public:
  OSMesaHeadlessContext(const Library& library, OSMesaHandle handle)
    : Lib(library)
    , Handle(handle)
  {
  }

  ~OSMesaHeadlessContext() override
  {
    this->Release();
    this->Lib.DestroyContext(this->Handle);
  }

  bool IsCurrent() const override
  {
    return this->Lib.DispatchGetCurrentThreadState() == &this->State &&
      this->Lib.GetCurrentContext() == this->Handle;
  }

  const char* GetBackendName() const override { return "OSMesa"; }
  void* GetNativeContext() const override { return this->Handle; }

  // libGLdispatch's entry points work with any current context, OSMesa's own addresses only with OSMesa.
  Proc GetProcAddress(const char* name) const override
  {
    const Proc entry = this->Lib.DispatchGetProcAddress(name);
    return entry ? entry : this->Lib.GetProcAddress(name);
  }

  const char* GetVersion() const
  {
    const auto getString = reinterpret_cast<const char* (*)(unsigned)>(
      this->Lib.GetProcAddress("glGetString"));
    return getString ? getString(VERSION) : nullptr;
  }

protected:
  bool Bind() override
  {
    this->Lib.DispatchCheckMultithreaded();
    if (!this->Lib.MakeCurrent(this->Handle, this->Pixel.data(), UNSIGNED_BYTE, 1, 1))
    {
      return false;
    }
    if (!this->Lib.DispatchMakeCurrent(&this->State, this->Lib.Table, this->Lib.VendorID, nullptr))
    {
      this->Lib.MakeCurrent(nullptr, nullptr, 0, 0, 0);
      return false;
    }
    return true;
  }

  void Unbind() override
  {
    this->Lib.DispatchLoseCurrent();
    this->Lib.MakeCurrent(nullptr, nullptr, 0, 0, 0);
  }

private:
  const Library& Lib;
  OSMesaHandle Handle;
  DispatchThreadState State{ OSMesaTag, IgnoreThreadEnd, nullptr };
  // OSMesa requires memory for a default framebuffer, but nothing is drawn into it.
  std::array<unsigned char, 4> Pixel{};
};

OSMesaHandle CreateHandle(const Library& library, GLVersion version)
{
  const int attributes[] = { OSMESA_FORMAT, RGBA, OSMESA_DEPTH_BITS, 0, OSMESA_STENCIL_BITS, 0,
    OSMESA_ACCUM_BITS, 0, OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION,
    version.Major, OSMESA_CONTEXT_MINOR_VERSION, version.Minor, 0, 0 };
  return library.CreateContextAttribs(attributes, nullptr);
}
}

std::shared_ptr<HeadlessContext> CreateOSMesaContext(ContextError& error)
{
  const Library& library = Library::Get();
  if (!library.IsUsable())
  {
    error = library.Error;
    return nullptr;
  }
  // 3.2 is requested only to report the version that the library supports.
  for (const GLVersion version : { PreferredGL, MinimumGL, GLVersion{ 3, 2 } })
  {
    const OSMesaHandle handle = CreateHandle(library, version);
    if (!handle)
    {
      continue;
    }
    auto context = std::make_shared<OSMesaHeadlessContext>(library, handle);
    const SavedContext previous = SavedContext::Capture();
    const bool current = context->MakeCurrent();
    const GLVersion found = ParseGLVersion(current ? context->GetVersion() : nullptr);
    context->Release();
    previous.Restore();
    if (!current)
    {
      error = { "OSMesa made an OpenGL context but could not make it current",
        "reinstall libosmesa6" };
      return nullptr;
    }
    if (IsAtLeast(found, MinimumGL))
    {
      return context;
    }
    error = { "OSMesa offers OpenGL " + ToString(found) + " where " + ToString(MinimumGL) +
        " is needed",
      "install libosmesa6 of Mesa 20.2 or later" };
    return nullptr;
  }
  error = { "OSMesa cannot make an OpenGL " + ToString(MinimumGL) + " core context",
    "install libosmesa6 of Mesa 20.2 or later" };
  return nullptr;
}
}
