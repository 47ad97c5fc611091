// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The framebuffer that is currently drawn to: that of VTK's window, or of a pass around this one, such as tone mapping.
 */
#pragma once

#include "gpu/GL.h"

namespace penumbra
{
/// Name of the framebuffer; 0 for a window's default framebuffer.
GLuint BoundFramebuffer();

/// Number of samples per pixel; 0 if the framebuffer is not multisampled.
int BoundSamples();

/// Internal format of one of its attachments; 0 if it cannot be determined.
GLenum BoundFormat(GLenum attachment);

/// Internal format of a texture.
GLenum TextureFormat(GLenum target, GLuint name);
}
