// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Collects what VTK would print, so that it becomes part of one clear sentence.
#pragma once

#include <string>
#include <vector>

namespace penumbra::tool
{
struct VtkMessages
{
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<std::string> Harmless; ///< called errors, but of no consequence
};

/// Routes VTK's output window and log into the collector, for the whole process.
void CollectVtkMessages();

/// The messages since the last call, stripped of file names and addresses, each once.
VtkMessages TakeVtkMessages();

/// Throws a Failure "WHAT (first error)" if VTK reported an error since the last call, or a warning that
/// amounts to one; other warnings are dropped.
void ThrowVtkErrors(const std::string& what);
}
