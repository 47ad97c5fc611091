// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shaders: embedded at build time from glsl/, replaceable from a folder at run time, with
 * #include resolved here (each file once, so includes need no guards) and programs cached by name
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
/// The embedded shaders: name relative to glsl/, text.
const std::map<std::string, const char*>& EmbeddedShaders();

/// Values that key a program: "SAMPLES" -> "16". The only thing that makes another program.
using Defines = std::map<std::string, std::string>;

/// A linked program. What it takes is looked up once.
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
    std::string Name; ///< of a block: the block's
    InputKind Kind;
    GLint Location; ///< of a value
    GLint Unit;     ///< of textures and images, or the block's binding
  };

  /// own: to be deleted with this. key: for messages. text: of its shaders, where names are to be checked.
  explicit Program(GLuint name, bool own = true, std::string key = {}, std::string text = {})
    : Name(name)
    , Own(own)
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
  /// Whether a word is in the text.
  bool Mentions(const std::string& name) const;

  /// Set a uniform; nothing where the program has none at the location.
  void SetValue(GLint location, const Arguments::Value& value) const;
  /// Set those of the values that the program uses.
  void SetValues(const Arguments& values) const;

protected:
  /// The name by which a uniform goes in the program's text.
  virtual std::string NameOf(const std::string& uniform) const { return uniform; }

private:
  GLuint Name;
  bool Own;
  std::string Label;
  std::string Text;
  mutable std::map<std::string, GLint> Locations;
  mutable std::vector<Input> Reflected;
  mutable bool IsReflected = false;
};

class ShaderLibrary
{
public:
  /// The folder whose files replace embedded ones; "" for none. Drops cached programs.
  void SetOverrideFolder(const std::string& folder);
  const std::string& OverrideFolder() const { return this->Folder; }

  /// A shader's text with includes resolved and defines inserted after its #version line. Throws
  /// std::runtime_error, naming the shader and the remedy, for a missing file.
  std::string Source(const std::string& name, const Defines& defines = {}) const;

  /// A program of a full-screen vertex shader and a fragment shader ("direct_light/resolve.frag").
  /// Throws std::runtime_error with the compiler's message where it does not compile.
  const Program& Fragment(const std::string& name, const Defines& defines = {});

  /// A program of these vertex and fragment shaders, both with the defines.
  const Program& Raster(
    const std::string& vertex, const std::string& fragment, const Defines& defines = {});

  /// A program of one compute shader.
  const Program& Compute(const std::string& name, const Defines& defines = {});

  /// Compile a shader's text and throw it away. Throws std::runtime_error, naming it and with the
  /// compiler's message, where it does not compile.
  void Check(const std::string& name, GLenum stage, const std::string& text) const;

  /// Free all programs; the context that made them must be current.
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
