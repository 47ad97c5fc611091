// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// OpenGL on the CPU by Mesa's OSMesa, if there is no usable EGL. libOSMesa and libGLdispatch are
// loaded at run time.

#pragma once

#include "headless/HeadlessContext.h"

namespace penumbra
{
/// Create a context. Returns null and sets the error if OSMesa cannot be used.
std::shared_ptr<HeadlessContext> CreateOSMesaContext(ContextError& error);
}
