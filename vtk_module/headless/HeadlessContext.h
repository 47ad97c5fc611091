// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// An OpenGL context that needs no window system, and the bookkeeping of which context is current.

#pragma once

#include <initializer_list>
#include <memory>
#include <string>

namespace penumbra
{
/// The oldest OpenGL that is accepted (compute shaders, storage buffers), and the one asked for.
struct GLVersion
{
  int Major;
  int Minor;
};
constexpr GLVersion MinimumGL{ 4, 3 };
constexpr GLVersion PreferredGL{ 4, 5 };

/// Why there is no context, in two clauses that make one sentence: "<Cause>; <Remedy>."
struct ContextError
{
  std::string Cause;
  std::string Remedy;
};

/// One OpenGL core context with a token surface: VTK draws into framebuffers of its own.
class HeadlessContext : public std::enable_shared_from_this<HeadlessContext>
{
public:
  using Proc = void (*)();

  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  /// Derived destructors call Release() first: a context is never destroyed while current.
  virtual ~HeadlessContext();

  /// Makes this context current in the calling thread, properly releasing another one if need be.
  bool MakeCurrent();

  /// Leaves the calling thread without a context, if this one is current in it.
  void Release();

  /// Asks the library, not our own notes: other code may have changed what is current.
  virtual bool IsCurrent() const = 0;

  virtual const char* GetBackendName() const = 0;
  virtual void* GetNativeContext() const = 0;
  virtual void* GetNativeDisplay() const { return nullptr; }

  /// Address of an OpenGL function, valid for every context of the process where the platform
  /// has a dispatching library (libglvnd).
  virtual Proc GetProcAddress(const char* name) const = 0;

protected:
  HeadlessContext() = default;

  virtual bool Bind() = 0;
  virtual void Unbind() = 0;
};

/// What was current in the calling thread: one of ours, or another library's EGL or GLX context.
class SavedContext
{
public:
  /// Notes what is current.
  static SavedContext Capture();

  /// Makes it current again; with nothing noted, or a context since destroyed, does nothing.
  void Restore() const;

private:
  enum class Owner
  {
    Nobody,
    Penumbra,
    ForeignEGL,
    ForeignGLX
  };
  Owner From = Owner::Nobody;
  std::weak_ptr<HeadlessContext> Own;
  void* Display = nullptr;
  void* Context = nullptr;
  // GLX drawables are integers, EGL surfaces pointers.
  void* Draw = nullptr;
  void* Read = nullptr;
};

/// Opens the first of `names` that loads, with local symbols; null and the last reason otherwise.
void* OpenLibrary(std::initializer_list<const char*> names, std::string& reason);

/// "4.3", and reads the leading "major.minor" of a GL_VERSION string.
std::string ToString(GLVersion version);
GLVersion ParseGLVersion(const char* text);
inline bool IsAtLeast(GLVersion have, GLVersion wanted)
{
  return have.Major > wanted.Major || (have.Major == wanted.Major && have.Minor >= wanted.Minor);
}
}
