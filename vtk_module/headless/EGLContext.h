// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// OpenGL through EGL without a window system: a GPU by the device platform, else Mesa's surfaceless
// platform. libEGL.so.1 is opened at run time.

#pragma once

#include "headless/HeadlessContext.h"

namespace penumbra
{
/// A context on EGL device `device`; with -1 the first hardware device that gives an accepted
/// OpenGL, then Mesa's surfaceless platform, then software devices. Null and the error otherwise.
std::shared_ptr<HeadlessContext> CreateEGLContext(int device, ContextError& error);

/// Number of devices that EGL lists; 0 without EGL or without its device extensions.
int CountEGLDevices();
}
