// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// An OpenGL context that needs no window system, and the tracking of the current context.

#pragma once

#include <initializer_list>
#include <memory>
#include <string>

namespace penumbra
{
/// A version of OpenGL. The minimum is that of compute shaders and storage buffers; the preferred one is requested
/// first.
struct GLVersion
{
  int Major;
  int Minor;
};
constexpr GLVersion MinimumGL{ 4, 3 };
constexpr GLVersion PreferredGL{ 4, 5 };

/// Reason why a context could not be created, as two clauses of a sentence: "<Cause>; <Remedy>."
struct ContextError
{
  std::string Cause;
  std::string Remedy;
};

/// An OpenGL core context with a minimal surface, as VTK draws into its own framebuffers.
class HeadlessContext : public std::enable_shared_from_this<HeadlessContext>
{
public:
  using Proc = void (*)();

  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  /// Destructors of derived classes must call Release() first, so that no context is destroyed while current.
  virtual ~HeadlessContext();

  /// Make this context current in the calling thread, after releasing another one if necessary.
  bool MakeCurrent();

  /// Leave the calling thread without a context if this one is current in it.
  void Release();

  /// Whether this context is current. Asks the library, as other code may have changed the current context.
  virtual bool IsCurrent() const = 0;

  virtual const char* GetBackendName() const = 0;
  virtual void* GetNativeContext() const = 0;
  virtual void* GetNativeDisplay() const { return nullptr; }

  /// Address of an OpenGL function. It is valid for all contexts of the process if the platform
  /// has a dispatching library (libglvnd).
  virtual Proc GetProcAddress(const char* name) const = 0;

protected:
  HeadlessContext() = default;

  virtual bool Bind() = 0;
  virtual void Unbind() = 0;
};

/// The context that was current in the calling thread: one of ours, or another library's EGL or GLX context.
class SavedContext
{
public:
  /// Save the current context.
  static SavedContext Capture();

  /// Make it current again. Does nothing if there was none or if it has been destroyed since.
  void Restore() const;

private:
  enum class Owner
  {
    Nobody,
    Penumbra,
    ForeignEGL,
    ForeignGLX
  };
  Owner Source = Owner::Nobody;
  std::weak_ptr<HeadlessContext> OwnContext;
  void* Display = nullptr;
  void* Context = nullptr;
  // GLX drawables are integers, EGL surfaces pointers.
  void* Draw = nullptr;
  void* Read = nullptr;
};

/// Load the first of `names` that can be loaded, with local symbols. Returns null and sets the reason on failure.
void* OpenLibrary(std::initializer_list<const char*> names, std::string& reason);

/// A version as text: "4.3".
std::string ToString(GLVersion version);
/// Parse the leading "major.minor" of a GL_VERSION string.
GLVersion ParseGLVersion(const char* text);
inline bool IsAtLeast(GLVersion have, GLVersion wanted)
{
  return have.Major > wanted.Major || (have.Major == wanted.Major && have.Minor >= wanted.Minor);
}
}
