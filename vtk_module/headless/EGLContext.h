// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// OpenGL through EGL without a window system: on a GPU by the device platform, else by Mesa's surfaceless
// platform. libEGL.so.1 is loaded at run time.

#pragma once

#include "headless/HeadlessContext.h"

namespace penumbra
{
/// Create a context on EGL device `device`. With -1, try hardware devices, then Mesa's surfaceless platform, then
/// software devices, and use the first that supports a sufficient OpenGL. Returns null and sets the error on failure.
std::shared_ptr<HeadlessContext> CreateEGLContext(int device, ContextError& error);

/// Number of devices that EGL lists; 0 if EGL or its device extensions are missing.
int CountEGLDevices();
}
