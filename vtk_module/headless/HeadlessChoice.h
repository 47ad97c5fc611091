// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Chooses the backend of a context by the program's and the environment's settings.
 */
#pragma once

#include "headless/HeadlessContext.h"

#include <memory>
#include <string>

namespace penumbra
{
/// Backend that a program or PENUMBRA_BACKEND requests.
enum class BackendWish
{
  None, ///< unset, empty or auto
  EGL,
  OSMesa,
  X11,
  Unknown
};
BackendWish ReadBackendWish();

/// Error message for BackendWish::Unknown, in one sentence.
std::string DescribeUnknownBackend();

/// Value of an environment variable, or an empty text.
const char* ReadVariable(const char* name);

/// Create a context by `wish`, or by PENUMBRA_BACKEND if that is None, on EGL device `device`, or
/// PENUMBRA_EGL_DEVICE if that is negative. Returns null and sets the error to one sentence on failure.
std::shared_ptr<HeadlessContext> ChooseContext(BackendWish wish, int device, std::string& error);
}
