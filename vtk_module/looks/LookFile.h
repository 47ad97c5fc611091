// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the text of a look. The format is described in docs/looks.md.
 */
#pragma once

#include "looks/LookDescription.h"

#include <stdexcept>

class vtkGIPass;

namespace penumbra
{
/// What is wrong with a look, as one sentence.
struct LookError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Reads a look. name: its name in messages. pass: the techniques that it may name. Throws a LookError.
LookDescription ReadLook(const std::string& text, const std::string& name, vtkGIPass* pass);
}
