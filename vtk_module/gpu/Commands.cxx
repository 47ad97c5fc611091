// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/Commands.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

#include <cstdlib>
#include <stdexcept>

namespace penumbra
{
namespace
{
constexpr std::size_t MaxGroups = 32768; // per dimension; OpenGL 4.3 guarantees 65535

template <typename T>
const T* Find(const std::map<std::string, T>& given, const std::map<std::string, T>& offered,
  const std::string& name)
{
  auto found = given.find(name);
  if (found != given.end())
  {
    return &found->second;
  }
  found = offered.find(name);
  return found == offered.end() ? nullptr : &found->second;
}

GLenum ImageAccess(ShaderAccess access)
{
  return access == ShaderAccess::Read ? GL_READ_ONLY
    : access == ShaderAccess::Write   ? GL_WRITE_ONLY
                                      : GL_READ_WRITE;
}

GLuint NameOf(const Arguments::Bound& bound)
{
  return bound.Object ? bound.Object->Get() : bound.Name;
}
}

Work Work::GroupsInRows(std::size_t count)
{
  const std::size_t width = std::max<std::size_t>(std::min(count, MaxGroups), 1);
  return Groups(static_cast<int>(width), static_cast<int>((count + width - 1) / width));
}

glm::ivec2 Work::GroupsOf(const Program& program) const
{
  if (this->InGroups)
  {
    return this->Count;
  }
  const glm::ivec2 group = program.GroupSize();
  const auto width = static_cast<std::size_t>(group.x);
  return this->ItemCount > 0 ? GroupsInRows((this->ItemCount + width - 1) / width).Count
                             : (this->Count + group - 1) / group;
}

Commands::Commands(ShaderLibrary& shaders)
  : Library(shaders)
  , ChecksShaders(std::getenv("PENUMBRA_CHECK_SHADERS") != nullptr)
{
}

void Commands::InsertBarrier(const Object& object, GLbitfield use)
{
  const auto found = this->Written.find(object);
  if (found == this->Written.end() || (found->second & use) != 0)
  {
    return;
  }
  ++this->Barriers;
  glMemoryBarrier(use);
  for (auto& written : this->Written)
  {
    written.second |= use;
  }
}

void Commands::BeforeUse(const Texture& texture, GLbitfield use)
{
  this->InsertBarrier({ OfTexture, texture.Get() }, use);
}

void Commands::BeforeUse(const Buffer& buffer, GLbitfield use)
{
  this->InsertBarrier({ OfBuffer, buffer.Get() }, use);
}

void Commands::Finish()
{
  if (!this->Written.empty())
  {
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    this->Written.clear();
  }
}

void Commands::Check(const Program& program, const Arguments& given, const Arguments& offered) const
{
  const auto fail = [&program](const std::string& what) {
    throw std::logic_error("the shader " + program.Key() + " " + what);
  };
  const auto known = [&](const auto& names) {
    for (const auto& entry : names)
    {
      if (!program.Mentions(entry.first))
      {
        fail("does not know '" + entry.first + "', which it is given");
      }
    }
  };
  known(given.Values());
  known(given.Samplers());
  known(given.Images());
  known(given.Blocks());
  for (const Program::Input& input : program.Inputs())
  {
    const bool bound = input.Kind == Program::InputKind::Value
      ? Find(given.Values(), offered.Values(), input.Name) != nullptr
      : input.Kind == Program::InputKind::Sampler
      ? Find(given.Samplers(), offered.Samplers(), input.Name) != nullptr
      : input.Kind == Program::InputKind::Image
      ? Find(given.Images(), offered.Images(), input.Name) != nullptr
      : Find(given.Blocks(), offered.Blocks(), input.Name) != nullptr;
    if (!bound)
    {
      fail("is not given '" + input.Name + "'");
    }
  }
}

void Commands::Use(const Program& program, const Arguments& given, const Arguments& offered)
{
  // Replacement shaders may omit inputs.
  if (this->ChecksShaders && this->Library.OverrideFolder().empty())
  {
    this->Check(program, given, offered);
  }
  // Our program is bound without VTK's knowledge, so invalidate its cache of the current program.
  this->Window->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(program.Get());
  for (const Program::Input& input : program.Inputs())
  {
    switch (input.Kind)
    {
      case Program::InputKind::Value:
        if (const auto* value = Find(given.Values(), offered.Values(), input.Name))
        {
          program.SetValue(input.Location, *value);
        }
        break;
      case Program::InputKind::Sampler:
        if (const auto* sampler = Find(given.Samplers(), offered.Samplers(), input.Name))
        {
          this->InsertBarrier({ OfTexture, NameOf(*sampler) }, GL_TEXTURE_FETCH_BARRIER_BIT);
          this->Window->GetState()->vtkglActiveTexture(
            GL_TEXTURE0 + static_cast<GLenum>(input.Unit));
          glBindTexture(
            sampler->Object ? sampler->Object->Target() : sampler->Target, NameOf(*sampler));
        }
        break;
      case Program::InputKind::Image:
        if (const auto* image = Find(given.Images(), offered.Images(), input.Name))
        {
          const bool layered = image->Object && image->Object->Desc().Layers > 0;
          this->InsertBarrier({ OfTexture, NameOf(*image) }, GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
          glBindImageTexture(static_cast<GLuint>(input.Unit), NameOf(*image), 0,
            layered ? GL_TRUE : GL_FALSE, 0, ImageAccess(image->Access),
            image->Object ? image->Object->Desc().Format : image->Format);
        }
        break;
      case Program::InputKind::UniformBlock:
      case Program::InputKind::StorageBlock:
        if (const auto* block = Find(given.Blocks(), offered.Blocks(), input.Name))
        {
          const bool storage = input.Kind == Program::InputKind::StorageBlock;
          this->InsertBarrier({ OfBuffer, block->Object->Get() },
            storage ? GL_SHADER_STORAGE_BARRIER_BIT : GL_UNIFORM_BARRIER_BIT);
          block->Object->BindBase(storage ? GL_SHADER_STORAGE_BUFFER : GL_UNIFORM_BUFFER,
            static_cast<GLuint>(input.Unit));
        }
        break;
    }
  }
  // Mark outputs after all barriers of this program, so that only later programs wait for them.
  for (const Program::Input& input : program.Inputs())
  {
    const auto* image = input.Kind == Program::InputKind::Image
      ? Find(given.Images(), offered.Images(), input.Name)
      : nullptr;
    const auto* block = input.Kind == Program::InputKind::StorageBlock
      ? Find(given.Blocks(), offered.Blocks(), input.Name)
      : nullptr;
    if (image && image->Access != ShaderAccess::Read)
    {
      this->MarkWritten({ OfTexture, NameOf(*image) });
    }
    if (block && block->Access != ShaderAccess::Read)
    {
      this->MarkWritten({ OfBuffer, block->Object->Get() });
    }
  }
}

void Commands::Dispatch(
  const Program& program, const Arguments& given, const Work& work, const Arguments& offered)
{
  this->Use(program, given, offered);
  const glm::ivec2 groups = work.GroupsOf(program);
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
}
}
