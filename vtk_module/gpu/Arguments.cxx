// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/Arguments.h"

#include <cstring>

namespace penumbra
{
template <typename T>
Arguments& Arguments::Put(const std::string& name, GLenum type, const T* values, std::size_t count)
{
  static_assert(sizeof(T) % sizeof(std::uint32_t) == 0, "a value consists of whole words");
  Value value{ type, static_cast<GLsizei>(count),
    std::vector<std::uint32_t>(count * sizeof(T) / sizeof(std::uint32_t)) };
  std::memcpy(value.Words.data(), values, count * sizeof(T));
  this->AllValues[name] = std::move(value);
  return *this;
}

Arguments& Arguments::Set(const std::string& name, bool value)
{
  return this->Set(name, value ? 1 : 0);
}

Arguments& Arguments::Set(const std::string& name, int value)
{
  return this->Put(name, GL_INT, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, double value)
{
  const auto rounded = static_cast<float>(value);
  return this->Put(name, GL_FLOAT, &rounded, 1);
}

Arguments& Arguments::Set(const std::string& name, const glm::vec2& value)
{
  return this->Put(name, GL_FLOAT_VEC2, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, const glm::vec3& value)
{
  return this->Put(name, GL_FLOAT_VEC3, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, const glm::vec4& value)
{
  return this->Put(name, GL_FLOAT_VEC4, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, const glm::ivec2& value)
{
  return this->Put(name, GL_INT_VEC2, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, const glm::ivec3& value)
{
  return this->Put(name, GL_INT_VEC3, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, const glm::mat3& value)
{
  return this->Put(name, GL_FLOAT_MAT3, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, const glm::mat4& value)
{
  return this->Put(name, GL_FLOAT_MAT4, &value, 1);
}

Arguments& Arguments::Set(const std::string& name, const std::vector<int>& values)
{
  return this->Put(name, GL_INT, values.data(), values.size());
}

Arguments& Arguments::Set(const std::string& name, const std::vector<glm::vec3>& values)
{
  return this->Put(name, GL_FLOAT_VEC3, values.data(), values.size());
}

Arguments& Arguments::Set(const std::string& name, const std::vector<glm::vec4>& values)
{
  return this->Put(name, GL_FLOAT_VEC4, values.data(), values.size());
}

Arguments& Arguments::Set(const std::string& name, const std::vector<glm::ivec2>& values)
{
  return this->Put(name, GL_INT_VEC2, values.data(), values.size());
}

Arguments& Arguments::Set(const std::string& name, const std::vector<glm::ivec3>& values)
{
  return this->Put(name, GL_INT_VEC3, values.data(), values.size());
}

Arguments& Arguments::Sample(const std::string& name, const Texture* texture)
{
  if (texture)
  {
    this->AllSamplers[name] = { texture, 0, 0, 0, ShaderAccess::Read };
  }
  return *this;
}

Arguments& Arguments::Sample(const std::string& name, GLenum target, GLuint texture)
{
  this->AllSamplers[name] = { nullptr, texture, target, 0, ShaderAccess::Read };
  return *this;
}

Arguments& Arguments::Image(const std::string& name, const Texture& texture, ShaderAccess access)
{
  this->AllImages[name] = { &texture, 0, 0, 0, access };
  return *this;
}

Arguments& Arguments::Image(const std::string& name, GLuint bufferTexture, GLenum format)
{
  this->AllImages[name] = { nullptr, bufferTexture, GL_TEXTURE_BUFFER, format, ShaderAccess::Read };
  return *this;
}

Arguments& Arguments::Block(const std::string& name, const Buffer& buffer, ShaderAccess access)
{
  this->AllBlocks[name] = { &buffer, access };
  return *this;
}

Arguments& Arguments::Add(const Arguments& others)
{
  const auto add = [](auto& to, const auto& from) {
    for (const auto& entry : from)
    {
      to[entry.first] = entry.second;
    }
  };
  add(this->AllValues, others.AllValues);
  add(this->AllSamplers, others.AllSamplers);
  add(this->AllImages, others.AllImages);
  add(this->AllBlocks, others.AllBlocks);
  return *this;
}
}
