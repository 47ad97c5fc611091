// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/ShaderLibrary.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace penumbra
{
Program::~Program()
{
  if (this->OwnsProgram)
  {
    // A deleted program stays current until it is unbound. VTK would find it and try to restore it later.
    GLint used = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &used);
    if (used == static_cast<GLint>(this->Name))
    {
      glUseProgram(0);
    }
    glDeleteProgram(this->Name);
  }
}

namespace
{
bool IsImage(GLint type)
{
  return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY;
}

bool IsValue(GLint type)
{
  constexpr GLint values[] = { GL_BOOL, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_FLOAT_VEC2,
    GL_FLOAT_VEC3, GL_FLOAT_VEC4, GL_INT_VEC2, GL_INT_VEC3, GL_INT_VEC4, GL_FLOAT_MAT3,
    GL_FLOAT_MAT4 };
  return std::find(std::begin(values), std::end(values), type) != std::end(values);
}

std::string ResourceName(GLuint program, GLenum interface, GLuint index)
{
  char name[256] = "";
  glGetProgramResourceName(program, interface, index, sizeof(name), nullptr, name);
  const std::string all = name;
  return all.substr(0, all.find('['));
}

GLint CountOf(GLuint program, GLenum interface)
{
  GLint count = 0;
  glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  return count;
}
}

const std::vector<Program::Input>& Program::Inputs() const
{
  if (this->IsReflected)
  {
    return this->Reflected;
  }
  this->IsReflected = true;
  const GLint uniforms = CountOf(this->Name, GL_UNIFORM);
  for (GLint i = 0; i < uniforms; ++i)
  {
    constexpr GLenum wanted[] = { GL_LOCATION, GL_TYPE };
    GLint found[2] = { -1, 0 };
    glGetProgramResourceiv(
      this->Name, GL_UNIFORM, static_cast<GLuint>(i), 2, wanted, 2, nullptr, found);
    if (found[0] < 0)
    {
      continue; // in a block
    }
    Input input{ ResourceName(this->Name, GL_UNIFORM, static_cast<GLuint>(i)), InputKind::Value,
      found[0], 0 };
    if (!IsValue(found[1]))
    {
      input.Kind = IsImage(found[1]) ? InputKind::Image : InputKind::Sampler;
      glGetUniformiv(this->Name, input.Location, &input.Unit);
    }
    this->Reflected.push_back(input);
  }
  for (const GLenum interface : { GL_UNIFORM_BLOCK, GL_SHADER_STORAGE_BLOCK })
  {
    const GLint blocks = CountOf(this->Name, interface);
    for (GLint i = 0; i < blocks; ++i)
    {
      constexpr GLenum wanted = GL_BUFFER_BINDING;
      Input input{ ResourceName(this->Name, interface, static_cast<GLuint>(i)),
        interface == GL_UNIFORM_BLOCK ? InputKind::UniformBlock : InputKind::StorageBlock, -1, 0 };
      glGetProgramResourceiv(
        this->Name, interface, static_cast<GLuint>(i), 1, &wanted, 1, nullptr, &input.Unit);
      this->Reflected.push_back(input);
    }
  }
  return this->Reflected;
}

const glm::ivec2& Program::GroupSize() const
{
  if (this->Group.x == 0)
  {
    GLint size[3] = { 1, 1, 1 };
    glGetProgramiv(this->Name, GL_COMPUTE_WORK_GROUP_SIZE, size);
    this->Group = { size[0], size[1] };
  }
  return this->Group;
}

bool Program::Mentions(const std::string& name) const
{
  const auto inWord = [](
                        char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t at = this->Text.find(name); at != std::string::npos;
       at = this->Text.find(name, at + 1))
  {
    const std::size_t end = at + name.size();
    if ((at == 0 || !inWord(this->Text[at - 1])) &&
      (end == this->Text.size() || !inWord(this->Text[end])))
    {
      return true;
    }
  }
  return false;
}

void Program::SetValue(GLint location, const Arguments::Value& value) const
{
  const auto* whole = reinterpret_cast<const GLint*>(value.Words.data());
  const auto* real = reinterpret_cast<const GLfloat*>(value.Words.data());
  switch (value.Type)
  {
    case GL_INT:
      glProgramUniform1iv(this->Name, location, value.Count, whole);
      break;
    case GL_INT_VEC2:
      glProgramUniform2iv(this->Name, location, value.Count, whole);
      break;
    case GL_INT_VEC3:
      glProgramUniform3iv(this->Name, location, value.Count, whole);
      break;
    case GL_FLOAT:
      glProgramUniform1fv(this->Name, location, value.Count, real);
      break;
    case GL_FLOAT_VEC2:
      glProgramUniform2fv(this->Name, location, value.Count, real);
      break;
    case GL_FLOAT_VEC3:
      glProgramUniform3fv(this->Name, location, value.Count, real);
      break;
    case GL_FLOAT_VEC4:
      glProgramUniform4fv(this->Name, location, value.Count, real);
      break;
    case GL_FLOAT_MAT3:
      glProgramUniformMatrix3fv(this->Name, location, value.Count, GL_FALSE, real);
      break;
    case GL_FLOAT_MAT4:
      glProgramUniformMatrix4fv(this->Name, location, value.Count, GL_FALSE, real);
      break;
    default:
      break;
  }
}

void Program::SetValues(const Arguments& values) const
{
  for (const auto& value : values.Values())
  {
    auto found = this->Locations.find(value.first);
    if (found == this->Locations.end())
    {
      const GLint location = glGetUniformLocation(this->Name, this->NameOf(value.first).c_str());
      found = this->Locations.emplace(value.first, location).first;
    }
    this->SetValue(found->second, value.second);
  }
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
// Silences the driver within a scope. VTK 9.4 and later log the driver's messages while debugging is on, but the
// compiler's errors are reported here.
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

// Compiles a shader. problem: set to the compiler's message if it does not compile.
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
  else if (source.find("main") == std::string::npos)
  {
    problem = "it has no function main()."; // Some drivers link it, and draw nothing.
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
  std::string text; // tests check names in it
  for (const auto& stage : stages)
  {
    text += std::getenv("PENUMBRA_CHECK_SHADERS") ? stage.second : "";
  }
  auto program = std::make_unique<Program>(glCreateProgram(), true, key, text);
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
