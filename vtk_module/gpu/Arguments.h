// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Arguments of a shader by the names in its text: values of uniforms, textures, images and
 * blocks. Textures and buffers are held by reference and must live until the shader has run.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace penumbra
{
enum class ShaderAccess
{
  Read,
  Write,
  ReadWrite
};

class Arguments
{
public:
  /// Set the value of a uniform. Doubles are rounded to floats.
  Arguments& Set(const std::string& name, bool value);
  Arguments& Set(const std::string& name, int value);
  Arguments& Set(const std::string& name, double value);
  Arguments& Set(const std::string& name, const glm::vec2& value);
  Arguments& Set(const std::string& name, const glm::vec3& value);
  Arguments& Set(const std::string& name, const glm::vec4& value);
  Arguments& Set(const std::string& name, const glm::ivec2& value);
  Arguments& Set(const std::string& name, const glm::ivec3& value);
  Arguments& Set(const std::string& name, const glm::mat3& value);
  Arguments& Set(const std::string& name, const glm::mat4& value);

  /// Set the first elements of an array.
  Arguments& Set(const std::string& name, const std::vector<int>& values);
  Arguments& Set(const std::string& name, const std::vector<glm::vec3>& values);
  Arguments& Set(const std::string& name, const std::vector<glm::vec4>& values);
  Arguments& Set(const std::string& name, const std::vector<glm::ivec2>& values);
  Arguments& Set(const std::string& name, const std::vector<glm::ivec3>& values);

  /// Set a sampler's texture. nullptr sets nothing, for variants of the shader without the sampler.
  Arguments& Sample(const std::string& name, const Texture* texture);
  Arguments& Sample(const std::string& name, GLenum target, GLuint texture);

  /// Set an image, with all layers of an array.
  Arguments& Image(const std::string& name, const Texture& texture, ShaderAccess access);
  /// Set a read-only image of a buffer's texels.
  Arguments& Image(const std::string& name, GLuint bufferTexture, GLenum format);

  /// Set the buffer of a uniform block or a storage block, by the name of the block.
  Arguments& Block(
    const std::string& name, const Buffer& buffer, ShaderAccess access = ShaderAccess::Read);

  /// Add other arguments, which replace those of the same names.
  Arguments& Add(const Arguments& others);

  struct Value
  {
    GLenum Type;
    GLsizei Count;
    std::vector<std::uint32_t> Words;
  };
  struct Bound
  {
    const Texture* Object = nullptr; ///< nullptr: the texture is given by Name, Target and Format
    GLuint Name = 0;
    GLenum Target = 0;
    GLenum Format = 0;
    ShaderAccess Access = ShaderAccess::Read;
  };
  struct BoundBuffer
  {
    const Buffer* Object = nullptr;
    ShaderAccess Access = ShaderAccess::Read;
  };
  const std::map<std::string, Value>& Values() const { return this->AllValues; }
  const std::map<std::string, Bound>& Samplers() const { return this->AllSamplers; }
  const std::map<std::string, Bound>& Images() const { return this->AllImages; }
  const std::map<std::string, BoundBuffer>& Blocks() const { return this->AllBlocks; }

private:
  template <typename T>
  Arguments& Put(const std::string& name, GLenum type, const T* values, std::size_t count);

  std::map<std::string, Value> AllValues;
  std::map<std::string, Bound> AllSamplers;
  std::map<std::string, Bound> AllImages;
  std::map<std::string, BoundBuffer> AllBlocks;
};
}
