// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs shaders: binds their arguments by the names that they are reflected under, dispatches, and
 * puts a memory barrier where something written by a shader is used next.
 */
#pragma once

#include "gpu/Arguments.h"
#include "gpu/ShaderLibrary.h"

#include <map>

class vtkOpenGLRenderWindow;

namespace penumbra
{
/// How much a compute shader does.
class Work
{
public:
  /// So many invocations, rounded up to whole groups.
  static Work Items(int x, int y = 1) { return { glm::ivec2(x, y), false }; }
  /// So many groups.
  static Work Groups(int x, int y = 1) { return { glm::ivec2(x, y), true }; }
  /// So many groups of a shader that counts them along x, then y: one direction holds too few.
  static Work GroupsInRows(std::size_t count);

  glm::ivec2 GroupsOf(const Program& program) const;

private:
  Work(const glm::ivec2& count, bool groups)
    : Count(count)
    , InGroups(groups)
  {
  }
  glm::ivec2 Count;
  bool InGroups;
};

class Commands
{
public:
  explicit Commands(ShaderLibrary& shaders)
    : Library(shaders)
  {
  }

  /// Whose context is current, before anything else.
  void SetWindow(vtkOpenGLRenderWindow* window) { this->Window = window; }
  ShaderLibrary& Shaders() const { return this->Library; }

  /// Make a program current with its arguments bound, to draw with. given: all of it must be in the shader's text.
  /// offered: what it takes of it. With PENUMBRA_CHECK_SHADERS in the environment, throws std::logic_error, naming
  /// program and argument, where the text lacks a name that is given, or nothing is bound to one that it uses.
  void Use(const Program& program, const Arguments& given, const Arguments& offered = {});

  /// Run a compute shader.
  void Dispatch(const Program& program, const Arguments& given, const Work& work,
    const Arguments& offered = {});

  /// Before a texture or buffer that a shader may have written is used in another way than as an argument.
  /// use: a bit of glMemoryBarrier.
  void BeforeUse(const Texture& texture, GLbitfield use);
  void BeforeUse(const Buffer& buffer, GLbitfield use);

  /// Before others use anything.
  void Finish();

  /// Barriers so far, but for those of Finish().
  int NumberOfBarriers() const { return this->Barriers; }

private:
  enum Kind
  {
    OfTexture,
    OfBuffer
  };
  using Object = std::pair<Kind, GLuint>;
  void Wait(const Object& object, GLbitfield use);
  void Wrote(const Object& object) { this->Written[object] = 0; }
  void Check(const Program& program, const Arguments& given, const Arguments& offered) const;

  ShaderLibrary& Library;
  vtkOpenGLRenderWindow* Window = nullptr;
  int Barriers = 0;
  std::map<Object, GLbitfield> Written; ///< by shaders; the uses that barriers since have made safe
};
}
