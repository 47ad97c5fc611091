// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs shaders: binds their arguments by reflected names, dispatches, and
 * inserts a memory barrier before the next use of anything that a shader has written.
 */
#pragma once

#include "gpu/Arguments.h"
#include "gpu/ShaderLibrary.h"

#include <map>

class vtkOpenGLRenderWindow;

namespace penumbra
{
/// Size of a dispatch.
class Work
{
public:
  /// A number of invocations, rounded up to whole groups.
  static Work Items(int x, int y = 1) { return { glm::ivec2(x, y), false }; }
  /// A number of groups.
  static Work Groups(int x, int y = 1) { return { glm::ivec2(x, y), true }; }
  /// A number of groups, possibly more than one dimension can hold. The shader counts them along x, then y.
  static Work GroupsInRows(std::size_t count);
  /// A number of invocations of a shader with one-dimensional groups, rounded up to whole groups, which the shader counts
  /// in the same way.
  static Work ItemsInRows(std::size_t count) { return { glm::ivec2(0), false, count }; }

  glm::ivec2 GroupsOf(const Program& program) const;

private:
  Work(const glm::ivec2& count, bool groups, std::size_t items = 0)
    : Count(count)
    , InGroups(groups)
    , ItemCount(items)
  {
  }
  glm::ivec2 Count;
  bool InGroups;
  std::size_t ItemCount; ///< 0 if Count holds the size
};

class Commands
{
public:
  explicit Commands(ShaderLibrary& shaders);

  /// Set the window whose context is current. Call this first.
  void SetWindow(vtkOpenGLRenderWindow* window) { this->Window = window; }
  ShaderLibrary& Shaders() const { return this->Library; }

  /// Make a program current with its arguments bound, for drawing. given: arguments that must all be in the shader's
  /// text. offered: arguments of which the shader may use any. With PENUMBRA_CHECK_SHADERS in the environment, throws
  /// std::logic_error, naming program and argument, if the text lacks a given name or an input of the shader is not
  /// bound.
  void Use(const Program& program, const Arguments& given, const Arguments& offered = {});

  /// Run a compute shader.
  void Dispatch(const Program& program, const Arguments& given, const Work& work,
    const Arguments& offered = {});

  /// Call this before using a texture or buffer that a shader may have written in another way than as an argument.
  /// use: a bit of glMemoryBarrier.
  void BeforeUse(const Texture& texture, GLbitfield use);
  void BeforeUse(const Buffer& buffer, GLbitfield use);

  /// Make everything that was written available to other code.
  void Finish();

  /// Number of barriers so far, except for those of Finish().
  int NumberOfBarriers() const { return this->Barriers; }

private:
  enum Kind
  {
    OfTexture,
    OfBuffer
  };
  using Object = std::pair<Kind, GLuint>;
  void InsertBarrier(const Object& object, GLbitfield use);
  void MarkWritten(const Object& object) { this->Written[object] = 0; }
  void Check(const Program& program, const Arguments& given, const Arguments& offered) const;

  ShaderLibrary& Library;
  bool ChecksShaders;
  vtkOpenGLRenderWindow* Window = nullptr;
  int Barriers = 0;
  /// Objects that shaders have written, with the uses for which there was a barrier since.
  std::map<Object, GLbitfield> Written;
};
}
