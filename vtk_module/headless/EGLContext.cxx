// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

#include "headless/EGLContext.h"

// Excludes X11's headers, which define macros named None and Status.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <dlfcn.h>
#include <mutex>
#include <vector>

#ifndef EGL_PLATFORM_SURFACELESS_MESA
#define EGL_PLATFORM_SURFACELESS_MESA 0x31DD
#endif

namespace penumbra
{
namespace
{
constexpr unsigned GL_VERSION_STRING = 0x1F02; // GL_VERSION
const char* const EGLRemedy =
  "install libegl1 and a driver for it (Mesa's software driver: libegl-mesa0 and libgl1-mesa-dri)";

bool HasWord(const char* list, const char* word)
{
  const size_t length = std::strlen(word);
  for (const char* found = list; found && (found = std::strstr(found, word)); found += length)
  {
    const bool starts = found == list || found[-1] == ' ';
    if (starts && (found[length] == ' ' || found[length] == '\0'))
    {
      return true;
    }
  }
  return false;
}

// libEGL and its functions, loaded once and never unloaded.
struct Library
{
  decltype(&eglGetProcAddress) GetProcAddress = nullptr;
  decltype(&eglQueryString) QueryString = nullptr;
  decltype(&eglInitialize) Initialize = nullptr;
  decltype(&eglGetDisplay) GetDisplay = nullptr;
  decltype(&eglBindAPI) BindAPI = nullptr;
  decltype(&eglQueryAPI) QueryAPI = nullptr;
  decltype(&eglChooseConfig) ChooseConfig = nullptr;
  decltype(&eglCreateContext) CreateContext = nullptr;
  decltype(&eglDestroyContext) DestroyContext = nullptr;
  decltype(&eglCreatePbufferSurface) CreatePbufferSurface = nullptr;
  decltype(&eglDestroySurface) DestroySurface = nullptr;
  decltype(&eglMakeCurrent) MakeCurrent = nullptr;
  decltype(&eglGetCurrentContext) GetCurrentContext = nullptr;
  decltype(&eglGetError) GetError = nullptr;
  // Extensions: null if EGL lacks them.
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay = nullptr;
  PFNEGLQUERYDEVICESEXTPROC QueryDevices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString = nullptr;

  ContextError Error;

  Library() { this->Load(); }
  bool IsUsable() const { return this->Error.Cause.empty(); }

  static const Library& Get()
  {
    static const Library library;
    return library;
  }

  const char* ClientExtensions() const { return this->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS); }

  std::vector<EGLDeviceEXT> Devices() const
  {
    EGLint count = 0;
    if (!this->QueryDevices || !this->GetPlatformDisplay ||
      !this->QueryDevices(0, nullptr, &count) || count <= 0)
    {
      return {};
    }
    std::vector<EGLDeviceEXT> devices(count);
    if (!this->QueryDevices(count, devices.data(), &count))
    {
      return {};
    }
    devices.resize(count);
    return devices;
  }

  bool IsSoftware(EGLDeviceEXT device) const
  {
    const char* extensions =
      this->QueryDeviceString ? this->QueryDeviceString(device, EGL_EXTENSIONS) : nullptr;
    return HasWord(extensions, "EGL_MESA_device_software");
  }

private:
  template <typename Function>
  static bool Find(void* library, const char* name, Function& function)
  {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
  }

  template <typename Function>
  void FindExtension(const char* name, Function& function)
  {
    function = reinterpret_cast<Function>(this->GetProcAddress(name));
  }

  void Load()
  {
    std::string reason;
    void* egl = OpenLibrary({ "libEGL.so.1", "libEGL.so" }, reason);
    if (!egl)
    {
      this->Error = { "EGL could not be loaded (" + reason + ")", EGLRemedy };
      return;
    }
    if (!(Find(egl, "eglGetProcAddress", this->GetProcAddress) &&
          Find(egl, "eglQueryString", this->QueryString) &&
          Find(egl, "eglInitialize", this->Initialize) &&
          Find(egl, "eglGetDisplay", this->GetDisplay) &&
          Find(egl, "eglBindAPI", this->BindAPI) && Find(egl, "eglQueryAPI", this->QueryAPI) &&
          Find(egl, "eglChooseConfig", this->ChooseConfig) &&
          Find(egl, "eglCreateContext", this->CreateContext) &&
          Find(egl, "eglDestroyContext", this->DestroyContext) &&
          Find(egl, "eglCreatePbufferSurface", this->CreatePbufferSurface) &&
          Find(egl, "eglDestroySurface", this->DestroySurface) &&
          Find(egl, "eglMakeCurrent", this->MakeCurrent) &&
          Find(egl, "eglGetCurrentContext", this->GetCurrentContext) &&
          Find(egl, "eglGetError", this->GetError)))
    {
      this->Error = { "the installed libEGL.so.1 lacks functions of EGL 1.4", EGLRemedy };
      return;
    }
    // Check for extensions first, as eglGetProcAddress may return addresses for missing ones.
    const char* extensions = this->ClientExtensions();
    if (HasWord(extensions, "EGL_EXT_platform_base"))
    {
      this->FindExtension("eglGetPlatformDisplayEXT", this->GetPlatformDisplay);
    }
    if (HasWord(extensions, "EGL_EXT_device_base") ||
      HasWord(extensions, "EGL_EXT_device_enumeration"))
    {
      this->FindExtension("eglQueryDevicesEXT", this->QueryDevices);
      this->FindExtension("eglQueryDeviceStringEXT", this->QueryDeviceString);
    }
  }
};

// Binds OpenGL as the thread's current client API, on which eglMakeCurrent and others operate, and restores the API
// that another library had bound.
class ScopedOpenGLAPI
{
public:
  explicit ScopedOpenGLAPI(const Library& library)
    : Lib(library)
    , PreviousAPI(library.QueryAPI())
    , Bound(library.BindAPI(EGL_OPENGL_API))
  {
  }
  ~ScopedOpenGLAPI()
  {
    if (this->PreviousAPI != EGL_OPENGL_API && this->PreviousAPI != EGL_NONE)
    {
      this->Lib.BindAPI(this->PreviousAPI);
    }
  }
  ScopedOpenGLAPI(const ScopedOpenGLAPI&) = delete;
  ScopedOpenGLAPI& operator=(const ScopedOpenGLAPI&) = delete;
  bool IsBound() const { return this->Bound; }

private:
  const Library& Lib;
  EGLenum PreviousAPI;
  bool Bound;
};

class EGLHeadlessContext final : public HeadlessContext
{
public:
  EGLHeadlessContext(const Library& library, EGLDisplay display, ::EGLContext context,
    EGLSurface surface)
    : Lib(library)
    , Display(display)
    , Handle(context)
    , Surface(surface)
  {
  }

  ~EGLHeadlessContext() override
  {
    this->Release();
    this->Lib.DestroyContext(this->Display, this->Handle);
    if (this->Surface != EGL_NO_SURFACE)
    {
      this->Lib.DestroySurface(this->Display, this->Surface);
    }
  }

  bool IsCurrent() const override { return this->Lib.GetCurrentContext() == this->Handle; }
  const char* GetBackendName() const override { return "EGL"; }
  void* GetNativeContext() const override { return this->Handle; }
  void* GetNativeDisplay() const override { return this->Display; }
  Proc GetProcAddress(const char* name) const override { return this->Lib.GetProcAddress(name); }

  const char* GetVersion() const
  {
    const auto getString =
      reinterpret_cast<const char* (*)(unsigned)>(this->Lib.GetProcAddress("glGetString"));
    return getString ? getString(GL_VERSION_STRING) : nullptr;
  }

protected:
  bool Bind() override
  {
    const ScopedOpenGLAPI api(this->Lib);
    return this->Lib.MakeCurrent(this->Display, this->Surface, this->Surface, this->Handle) ==
      EGL_TRUE;
  }

  void Unbind() override
  {
    const ScopedOpenGLAPI api(this->Lib);
    this->Lib.MakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

private:
  const Library& Lib;
  EGLDisplay Display;
  ::EGLContext Handle;
  EGLSurface Surface;
};

// A display to try, and its name in messages.
struct Candidate
{
  std::string Name;
  EGLDisplay Display;
};

::EGLContext CreateHandle(
  const Library& library, EGLDisplay display, EGLConfig config, GLVersion version)
{
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version.Major,
    EGL_CONTEXT_MINOR_VERSION, version.Minor, EGL_CONTEXT_OPENGL_PROFILE_MASK,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
  return library.CreateContext(display, config, EGL_NO_CONTEXT, attributes);
}

std::shared_ptr<HeadlessContext> CreateOn(
  const Library& library, const Candidate& candidate, std::string& reason)
{
  // Displays are never terminated, as all users of the library in the process share them.
  // Initialising one again costs nothing.
  EGLint major = 0;
  EGLint minor = 0;
  if (candidate.Display == EGL_NO_DISPLAY ||
    !library.Initialize(candidate.Display, &major, &minor))
  {
    reason = candidate.Name + " could not be initialised";
    return nullptr;
  }
  const ScopedOpenGLAPI api(library);
  if (!api.IsBound())
  {
    reason = candidate.Name + " offers OpenGL ES only";
    return nullptr;
  }

  // A pbuffer of one pixel gives the context a default framebuffer, which VTK queries and saves. A
  // driver without pbuffers may still support a surfaceless context.
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_NONE };
  const EGLint pixel[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint configs = 0;
  EGLSurface surface = EGL_NO_SURFACE;
  if (library.ChooseConfig(candidate.Display, wanted, &config, 1, &configs) && configs > 0)
  {
    surface = library.CreatePbufferSurface(candidate.Display, config, pixel);
  }
  else
  {
    config = nullptr; // EGL_NO_CONFIG_KHR
  }
  const char* extensions = library.QueryString(candidate.Display, EGL_EXTENSIONS);
  if (surface == EGL_NO_SURFACE && !HasWord(extensions, "EGL_KHR_surfaceless_context"))
  {
    reason = candidate.Name + " offers no pbuffer and no surfaceless context";
    return nullptr;
  }

  // 3.2 is requested only to report the version that the driver supports.
  for (const GLVersion version : { PreferredGL, MinimumGL, GLVersion{ 3, 2 } })
  {
    const ::EGLContext handle = CreateHandle(library, candidate.Display, config, version);
    if (handle == EGL_NO_CONTEXT)
    {
      continue;
    }
    // From here on the context also owns the surface.
    auto context =
      std::make_shared<EGLHeadlessContext>(library, candidate.Display, handle, surface);
    const SavedContext previous = SavedContext::Capture();
    const bool current = context->MakeCurrent();
    const GLVersion found = ParseGLVersion(current ? context->GetVersion() : nullptr);
    context->Release();
    previous.Restore();
    if (!current)
    {
      reason = candidate.Name + " made an OpenGL context that cannot be made current";
      return nullptr;
    }
    if (!IsAtLeast(found, MinimumGL))
    {
      reason = candidate.Name + " offers OpenGL " + ToString(found) + " where " +
        ToString(MinimumGL) + " is needed";
      return nullptr;
    }
    return context;
  }
  if (surface != EGL_NO_SURFACE)
  {
    library.DestroySurface(candidate.Display, surface);
  }
  reason = candidate.Name + " cannot make an OpenGL " + ToString(MinimumGL) + " core context";
  return nullptr;
}

std::vector<Candidate> ListCandidates(const Library& library)
{
  std::vector<Candidate> hardware;
  std::vector<Candidate> software;
  const std::vector<EGLDeviceEXT> devices = library.Devices();
  for (size_t i = 0; i < devices.size(); ++i)
  {
    (library.IsSoftware(devices[i]) ? software : hardware)
      .push_back({ "EGL device " + std::to_string(i),
        library.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr) });
  }
  std::vector<Candidate> candidates = std::move(hardware);
  if (library.GetPlatformDisplay &&
    HasWord(library.ClientExtensions(), "EGL_MESA_platform_surfaceless"))
  {
    candidates.push_back({ "EGL's surfaceless platform",
      library.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr) });
  }
  candidates.insert(candidates.end(), software.begin(), software.end());
  if (candidates.empty())
  {
    candidates.push_back({ "EGL's default display", library.GetDisplay(EGL_DEFAULT_DISPLAY) });
  }
  return candidates;
}
}

std::shared_ptr<HeadlessContext> CreateEGLContext(int device, ContextError& error)
{
  const Library& library = Library::Get();
  if (!library.IsUsable())
  {
    error = library.Error;
    return nullptr;
  }

  std::string reason;
  if (device >= 0)
  {
    const std::vector<EGLDeviceEXT> devices = library.Devices();
    if (device >= static_cast<int>(devices.size()))
    {
      error = { "EGL device " + std::to_string(device) + " does not exist: EGL lists " +
          std::to_string(devices.size()) + (devices.size() == 1 ? " device" : " devices"),
        devices.empty() ? "unset the device index"
                        : "choose a device index below " + std::to_string(devices.size()) };
      return nullptr;
    }
    const Candidate candidate{ "EGL device " + std::to_string(device),
      library.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[device], nullptr) };
    auto context = CreateOn(library, candidate, reason);
    if (!context)
    {
      error = { reason, "choose another device index or update its driver" };
    }
    return context;
  }

  // Probing all devices for each window would be slow, so remember the one that worked.
  static std::mutex mutex;
  static Candidate chosen{ {}, EGL_NO_DISPLAY };
  const std::lock_guard<std::mutex> lock(mutex);
  if (chosen.Display != EGL_NO_DISPLAY)
  {
    if (auto context = CreateOn(library, chosen, reason))
    {
      return context;
    }
  }
  std::string reasons;
  for (const Candidate& candidate : ListCandidates(library))
  {
    if (auto context = CreateOn(library, candidate, reason))
    {
      chosen = candidate;
      return context;
    }
    reasons += (reasons.empty() ? "" : ", ") + reason;
  }
  error = { reasons,
    "update the graphics driver, or install Mesa's software driver (libegl-mesa0 and "
    "libgl1-mesa-dri)" };
  return nullptr;
}

int CountEGLDevices()
{
  const Library& library = Library::Get();
  return library.IsUsable() ? static_cast<int>(library.Devices().size()) : 0;
}
}
