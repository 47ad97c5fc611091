// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/GLObjects.h"

#include <string>

namespace penumbra
{
bool IsSoftwareContext()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
}

namespace gl
{
void DeleteTexture(GLuint name)
{
  glDeleteTextures(1, &name);
}
void DeleteFramebuffer(GLuint name)
{
  glDeleteFramebuffers(1, &name);
}
void DeleteBuffer(GLuint name)
{
  glDeleteBuffers(1, &name);
}
void DeleteVertexArray(GLuint name)
{
  glDeleteVertexArrays(1, &name);
}
void DeleteQuery(GLuint name)
{
  glDeleteQueries(1, &name);
}
}

bool TextureDesc::IsDepth() const
{
  return this->Format == GL_DEPTH_COMPONENT32F || this->Format == GL_DEPTH_COMPONENT32 ||
    this->Format == GL_DEPTH_COMPONENT24 || this->Format == GL_DEPTH_COMPONENT16 ||
    this->Format == GL_DEPTH24_STENCIL8 || this->Format == GL_DEPTH32F_STENCIL8;
}

GLenum TextureDesc::DepthAttachment() const
{
  const bool stencil = this->Format == GL_DEPTH24_STENCIL8 || this->Format == GL_DEPTH32F_STENCIL8;
  return stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

std::size_t TextureDesc::Bytes() const
{
  std::size_t texel = 4;
  switch (this->Format)
  {
    case GL_R8:
      texel = 1;
      break;
    case GL_R16:
    case GL_RG8:
    case GL_R16F:
      texel = 2;
      break;
    case GL_RG32F:
    case GL_RG32UI:
    case GL_RGBA16:
    case GL_RGBA16F:
      texel = 8;
      break;
    case GL_RGBA32F:
    case GL_RGBA32UI:
      texel = 16;
      break;
    default:
      break;
  }
  return texel * this->Width * this->Height * (this->Layers > 0 ? this->Layers : 1);
}

Texture::Texture(const TextureDesc& desc)
  : Shape(desc)
{
  GLuint name = 0;
  glGenTextures(1, &name);
  this->Owned = Handle<gl::DeleteTexture>(name);
  const GLenum target = this->Target();
  glBindTexture(target, name);
  if (desc.Layers > 0)
  {
    glTexStorage3D(target, 1, desc.Format, desc.Width, desc.Height, desc.Layers);
  }
  else
  {
    glTexStorage2D(target, 1, desc.Format, desc.Width, desc.Height);
  }
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(target, 0);
}

Texture Texture::Borrow(GLuint name, const TextureDesc& desc)
{
  Texture texture;
  texture.Borrowed = name;
  texture.Shape = desc;
  return texture;
}

GLenum Texture::Target() const
{
  return this->Shape.Layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

void Texture::SetParameter(GLenum parameter, GLint value)
{
  glBindTexture(this->Target(), this->Get());
  glTexParameteri(this->Target(), parameter, value);
  glBindTexture(this->Target(), 0);
}

void Buffer::Upload(GLenum target, const void* data, std::size_t bytes)
{
  if (!this->Name)
  {
    GLuint name = 0;
    glGenBuffers(1, &name);
    this->Name = Handle<gl::DeleteBuffer>(name);
  }
  glBindBuffer(target, this->Name.Get());
  if (bytes > this->Capacity)
  {
    glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
    this->Capacity = bytes;
  }
  else if (bytes > 0)
  {
    glBufferSubData(target, 0, static_cast<GLsizeiptr>(bytes), data);
  }
  glBindBuffer(target, 0);
}

void Buffer::BindBase(GLenum target, GLuint index) const
{
  glBindBufferBase(target, index, this->Name.Get());
}
}
