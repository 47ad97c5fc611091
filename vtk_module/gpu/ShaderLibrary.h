// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Library of shaders. They are embedded at build time from glsl/ and can be replaced from a folder at run time.
 * The library resolves #include, each file once, so that files need no guards, and caches programs by name
 * and defines.
 */
#pragma once

#include "gpu/Arguments.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace penumbra
{
/// Texts of the embedded shaders by name, relative to glsl/.
const std::map<std::string, const char*>& EmbeddedShaders();

/// Macros that select the variant of a program: "SAMPLES" -> "16". Nothing else causes a recompilation.
using Defines = std::map<std::string, std::string>;

/// A linked program. Its inputs are looked up once.
class Program
{
public:
  enum class InputKind
  {
    Value,
    Sampler,
    Image,
    UniformBlock,
    StorageBlock
  };
  struct Input
  {
    std::string Name;
    InputKind Kind;
    GLint Location; ///< of a value
    GLint Unit;     ///< unit of a texture or image, or binding of a block
  };

  /// own: whether the program is deleted with this. key: name for messages. text: text of its shaders, if names are to
  /// be checked.
  explicit Program(GLuint name, bool own = true, std::string key = {}, std::string text = {})
    : Name(name)
    , OwnsProgram(own)
    , Label(std::move(key))
    , Text(std::move(text))
  {
  }
  virtual ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint Get() const { return this->Name; }
  const std::string& Key() const { return this->Label; }
  const std::vector<Input>& Inputs() const;
  /// Width and height of the work groups of a compute shader.
  const glm::ivec2& GroupSize() const;
  /// Whether the text contains a word.
  bool Mentions(const std::string& name) const;

  /// Set a uniform. Does nothing if the program has none at the location.
  void SetValue(GLint location, const Arguments::Value& value) const;
  /// Set those values that the program uses.
  void SetValues(const Arguments& values) const;

protected:
  /// Name of a uniform in the program's text.
  virtual std::string NameOf(const std::string& uniform) const { return uniform; }

private:
  GLuint Name;
  bool OwnsProgram;
  std::string Label;
  std::string Text;
  mutable std::map<std::string, GLint> Locations;
  mutable std::vector<Input> Reflected;
  mutable bool IsReflected = false;
  mutable glm::ivec2 Group{ 0 };
};

class ShaderLibrary
{
public:
  /// Set the folder whose files replace embedded ones; "" for none. Drops cached programs.
  void SetOverrideFolder(const std::string& folder);
  const std::string& OverrideFolder() const { return this->Folder; }

  /// Text of a shader with includes resolved and defines inserted after its #version line. Throws
  /// std::runtime_error, naming the shader and the remedy, if a file is missing.
  std::string Source(const std::string& name, const Defines& defines = {}) const;

  /// A program of a full-screen vertex shader and a fragment shader ("direct_light/resolve.frag").
  /// Throws std::runtime_error with the compiler's message if it does not compile.
  const Program& Fragment(const std::string& name, const Defines& defines = {});

  /// A program of a vertex shader and a fragment shader, both with the defines.
  const Program& Raster(
    const std::string& vertex, const std::string& fragment, const Defines& defines = {});

  /// A program of one compute shader.
  const Program& Compute(const std::string& name, const Defines& defines = {});

  /// Compile a shader's text and discard the result. Throws std::runtime_error with the shader's name and the
  /// compiler's message if it does not compile.
  void Check(const std::string& name, GLenum stage, const std::string& text) const;

  /// Number of programs that were compiled and are kept.
  std::size_t NumberOfPrograms() const { return this->Programs.size(); }

  /// Free all programs. The context that created them must be current.
  void Release() { this->Programs.clear(); }

private:
  void Append(const std::string& name, const std::string& from, std::set<std::string>& seen,
    std::string& text) const;
  const Program& Build(
    const std::string& key, const std::vector<std::pair<GLenum, std::string>>& stages);

  [[noreturn]] void Fail(const std::string& name, const std::string& problem) const;

  std::string Folder;
  std::map<std::string, std::unique_ptr<Program>> Programs;
};
}
