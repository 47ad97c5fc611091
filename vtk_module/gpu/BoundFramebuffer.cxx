// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/BoundFramebuffer.h"

namespace penumbra
{
namespace
{
GLint GetInteger(GLenum parameter)
{
  GLint value = 0;
  glGetIntegerv(parameter, &value);
  return value;
}
}

GLuint BoundFramebuffer()
{
  return static_cast<GLuint>(GetInteger(GL_DRAW_FRAMEBUFFER_BINDING));
}

int BoundSamples()
{
  return GetInteger(GL_SAMPLES);
}

GLenum TextureFormat(GLenum target, GLuint name)
{
  GLint format = 0;
  glBindTexture(target, name);
  glGetTexLevelParameteriv(target, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
  glBindTexture(target, 0);
  return static_cast<GLenum>(format);
}

GLenum BoundFormat(GLenum attachment)
{
  if (BoundFramebuffer() == 0)
  {
    return 0;
  }
  const auto getParameter = [attachment](GLenum parameter) {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, parameter, &value);
    return value;
  };
  const GLint type = getParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  if (type == GL_NONE)
  {
    return 0;
  }
  const auto name = static_cast<GLuint>(getParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  if (type == GL_TEXTURE)
  {
    return TextureFormat(BoundSamples() > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, name);
  }
  GLint format = 0;
  if (type == GL_RENDERBUFFER)
  {
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
  }
  return static_cast<GLenum>(format);
}
}
