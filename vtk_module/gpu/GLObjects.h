// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL objects that own their lifetime: move-only, freed on destruction. Their context must be
 * current when they are destroyed; the resource pool and the pass ensure that.
 */
#pragma once

#include "gpu/GL.h"

#include <cstddef>
#include <utility>

namespace penumbra
{
/// Whether the current context draws on the CPU, with Mesa's llvmpipe or softpipe.
bool IsSoftwareContext();

/// Name of an OpenGL object of one kind, freed by Delete.
template <void (*Delete)(GLuint)>
class Handle
{
public:
  Handle() = default;
  explicit Handle(GLuint name)
    : Name(name)
  {
  }
  Handle(Handle&& other) noexcept
    : Name(std::exchange(other.Name, 0))
  {
  }
  Handle& operator=(Handle&& other) noexcept
  {
    std::swap(this->Name, other.Name);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle()
  {
    if (this->Name)
    {
      Delete(this->Name);
    }
  }
  GLuint Get() const { return this->Name; }
  explicit operator bool() const { return this->Name != 0; }

private:
  GLuint Name = 0;
};

namespace gl
{
void DeleteTexture(GLuint name);
void DeleteFramebuffer(GLuint name);
void DeleteBuffer(GLuint name);
void DeleteVertexArray(GLuint name);
void DeleteQuery(GLuint name);
}

using FramebufferHandle = Handle<gl::DeleteFramebuffer>;
using VertexArrayHandle = Handle<gl::DeleteVertexArray>;
using QueryHandle = Handle<gl::DeleteQuery>;

/// Shape of a texture. Layers > 0 means an array texture, 0 a plain one.
struct TextureDesc
{
  GLenum Format = GL_RGBA8;
  int Width = 0;
  int Height = 0;
  int Layers = 0;

  bool operator==(const TextureDesc& o) const
  {
    return this->Format == o.Format && this->Width == o.Width && this->Height == o.Height &&
      this->Layers == o.Layers;
  }
  bool IsDepth() const;
  GLenum DepthAttachment() const; ///< attachment point of a framebuffer, for a depth format
  std::size_t Bytes() const;
};

/// A texture with immutable storage. Filtering is nearest and wrapping is clamp to edge unless changed. It may also
/// refer to a texture that VTK owns (Borrowed).
class Texture
{
public:
  explicit Texture(const TextureDesc& desc);
  static Texture Borrow(GLuint name, const TextureDesc& desc);
  Texture(Texture&&) noexcept = default;
  Texture& operator=(Texture&&) noexcept = default;

  GLuint Get() const { return this->Borrowed ? this->Borrowed : this->Owned.Get(); }
  bool IsBorrowed() const { return this->Borrowed != 0; }
  GLenum Target() const;
  const TextureDesc& Desc() const { return this->Shape; }
  void SetParameter(GLenum parameter, GLint value);

private:
  Texture() = default;
  Handle<gl::DeleteTexture> Owned;
  GLuint Borrowed = 0;
  TextureDesc Shape;
};

/// A buffer whose contents are replaced as a whole. It grows as needed.
class Buffer
{
public:
  void Upload(GLenum target, const void* data, std::size_t bytes);
  void BindBase(GLenum target, GLuint index) const;
  GLuint Get() const { return this->Name.Get(); }

private:
  Handle<gl::DeleteBuffer> Name;
  std::size_t Capacity = 0;
};
}
