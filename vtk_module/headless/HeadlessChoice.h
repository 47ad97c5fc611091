// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the environment asks for, and the context that comes of it.
 */
#pragma once

#include "headless/HeadlessContext.h"

#include <memory>
#include <string>

namespace penumbra
{
/// What a program or PENUMBRA_BACKEND asks for.
enum class BackendWish
{
  None, ///< unset, empty or auto
  EGL,
  OSMesa,
  X11,
  Unknown
};
BackendWish ReadBackendWish();

/// One sentence for BackendWish::Unknown.
std::string DescribeUnknownBackend();

/// The environment variable, or an empty text.
const char* ReadVariable(const char* name);

/// Makes a context by `wish`, or by PENUMBRA_BACKEND where that is None, on EGL device `device`, or
/// PENUMBRA_EGL_DEVICE where that is negative. Null and one sentence otherwise.
std::shared_ptr<HeadlessContext> ChooseContext(BackendWish wish, int device, std::string& error);
}
