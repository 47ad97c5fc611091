// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// OpenGL on the CPU by Mesa's OSMesa, where there is no usable EGL. libOSMesa and libGLdispatch are
// opened at run time.

#pragma once

#include "headless/HeadlessContext.h"

namespace penumbra
{
/// Null and the error where OSMesa cannot be used.
std::shared_ptr<HeadlessContext> CreateOSMesaContext(ContextError& error);
}
