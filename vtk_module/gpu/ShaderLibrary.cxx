// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/ShaderLibrary.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace penumbra
{
Program::~Program()
{
  if (this->Own)
  {
    // One that is in use stays for VTK to find, and put back when it is gone.
    GLint used = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &used);
    if (used == static_cast<GLint>(this->Name))
    {
      glUseProgram(0);
    }
    glDeleteProgram(this->Name);
  }
}

GLint Program::Location(const char* uniform) const
{
  auto found = this->Locations.find(uniform);
  if (found == this->Locations.end())
  {
    const GLint location = glGetUniformLocation(this->Name, this->NameOf(uniform).c_str());
    found = this->Locations.emplace(uniform, location).first;
  }
  return found->second;
}

void ShaderLibrary::SetOverrideFolder(const std::string& folder)
{
  this->Folder = folder;
  this->Release();
}

void ShaderLibrary::Append(const std::string& name, const std::string& from,
  std::set<std::string>& seen, std::string& text) const
{
  if (!seen.insert(name).second)
  {
    return;
  }
  std::stringstream lines;
  std::ifstream replacement;
  if (!this->Folder.empty())
  {
    replacement.open(this->Folder + "/" + name);
  }
  if (replacement.is_open())
  {
    lines << replacement.rdbuf();
  }
  else
  {
    auto found = EmbeddedShaders().find(name);
    if (found == EmbeddedShaders().end())
    {
      throw std::runtime_error("no shader is named '" + name + "'" +
        (from.empty() ? "" : ", which '" + from + "' includes") +
        (this->Folder.empty() ? "." : "; check the folder " + this->Folder + "."));
    }
    lines << found->second;
  }
  std::string line;
  while (std::getline(lines, line))
  {
    const auto directive = line.find("#include \"");
    if (directive == std::string::npos)
    {
      text += line + "\n";
      continue;
    }
    const auto begin = directive + 10;
    this->Append(line.substr(begin, line.find('"', begin) - begin), name, seen, text);
  }
}

std::string ShaderLibrary::Source(const std::string& name, const Defines& defines) const
{
  std::set<std::string> seen;
  std::string text;
  this->Append(name, "", seen, text);
  std::string header;
  for (const auto& define : defines)
  {
    header += "#define " + define.first + " " + define.second + "\n";
  }
  const auto version = text.find("#version");
  const auto position = version == std::string::npos ? 0 : text.find('\n', version) + 1;
  return text.insert(position, header);
}

namespace
{
std::string Key(const std::string& name, const Defines& defines)
{
  std::string key = name;
  for (const auto& define : defines)
  {
    key += "|" + define.first + "=" + define.second;
  }
  return key;
}

}

const Program& ShaderLibrary::Fragment(const std::string& name, const Defines& defines)
{
  const std::string key = Key(name, defines);
  auto found = this->Programs.find(key);
  if (found != this->Programs.end())
  {
    return *found->second;
  }
  return this->Build(key,
    { { GL_VERTEX_SHADER, this->Source("lib/fullscreen.vert") },
      { GL_FRAGMENT_SHADER, this->Source(name, defines) } });
}

const Program& ShaderLibrary::Raster(
  const std::string& vertex, const std::string& fragment, const Defines& defines)
{
  const std::string key = Key(vertex + "+" + fragment, defines);
  auto found = this->Programs.find(key);
  if (found != this->Programs.end())
  {
    return *found->second;
  }
  return this->Build(key,
    { { GL_VERTEX_SHADER, this->Source(vertex, defines) },
      { GL_FRAGMENT_SHADER, this->Source(fragment, defines) } });
}

const Program& ShaderLibrary::Compute(const std::string& name, const Defines& defines)
{
  const std::string key = Key(name, defines);
  auto found = this->Programs.find(key);
  if (found != this->Programs.end())
  {
    return *found->second;
  }
  return this->Build(key, { { GL_COMPUTE_SHADER, this->Source(name, defines) } });
}

void ShaderLibrary::Fail(const std::string& name, const std::string& problem) const
{
  throw std::runtime_error("the shader " + name + " does not compile" +
    (this->Folder.empty() ? "" : " (shaders are overridden from " + this->Folder + ")") + ": " +
    problem);
}

namespace
{
// VTK 9.4 and later log what the driver says while debugging is on. The compiler's errors are reported here, once: the
// driver is silent for the length of the scope.
class QuietDriver
{
public:
  QuietDriver()
    : WasOn(glIsEnabled(GL_DEBUG_OUTPUT) == GL_TRUE)
  {
    glDisable(GL_DEBUG_OUTPUT);
  }
  ~QuietDriver()
  {
    if (this->WasOn)
    {
      glEnable(GL_DEBUG_OUTPUT);
    }
  }
  QuietDriver(const QuietDriver&) = delete;
  QuietDriver& operator=(const QuietDriver&) = delete;

private:
  bool WasOn;
};

// A shader of this text; problem gets the compiler's message where it does not compile.
GLuint CompileShader(GLenum stage, const std::string& source, std::string& problem)
{
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled)
  {
    char log[2048] = "";
    glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
    problem = log;
  }
  return shader;
}
}

void ShaderLibrary::Check(const std::string& name, GLenum stage, const std::string& text) const
{
  const QuietDriver quiet;
  std::string problem;
  glDeleteShader(CompileShader(stage, text, problem));
  if (!problem.empty())
  {
    this->Fail(name, problem);
  }
}

const Program& ShaderLibrary::Build(
  const std::string& key, const std::vector<std::pair<GLenum, std::string>>& stages)
{
  const QuietDriver quiet;
  auto program = std::make_unique<Program>(glCreateProgram());
  std::string problem;
  for (const auto& stage : stages)
  {
    const GLuint shader = CompileShader(stage.first, stage.second, problem);
    glAttachShader(program->Get(), shader);
    glDeleteShader(shader); // kept alive by the program
  }
  if (problem.empty())
  {
    glLinkProgram(program->Get());
    GLint linked = GL_FALSE;
    glGetProgramiv(program->Get(), GL_LINK_STATUS, &linked);
    if (!linked)
    {
      char log[2048] = "";
      glGetProgramInfoLog(program->Get(), sizeof(log), nullptr, log);
      problem = log;
    }
  }
  if (!problem.empty())
  {
    this->Fail(key, problem);
  }
  return *(this->Programs[key] = std::move(program));
}
}
