// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is drawn to now: VTK's window, or a framebuffer of a pass around this one, as tone mapping has.
 */
#pragma once

#include "gpu/GL.h"

namespace penumbra
{
/// The framebuffer's name; 0 for a window's own.
GLuint BoundFramebuffer();

/// Samples of each of its pixels, 0 where it is not multisampled.
int BoundSamples();

/// The internal format of one of its attachments; 0 where it cannot be told.
GLenum BoundFormat(GLenum attachment);

/// The internal format of a texture.
GLenum TextureFormat(GLenum target, GLuint name);
}
