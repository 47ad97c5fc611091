// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Collects the messages of VTK, to report them in sentences of our own.
#pragma once

#include <string>
#include <vector>

namespace penumbra::tool
{
struct VtkMessages
{
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<std::string> Harmless; ///< reported as errors, but without consequences
};

/// Redirect VTK's output window and log to the collector, for the whole process.
void CollectVtkMessages();

/// Messages since the last call, without file names and addresses, and without duplicates.
VtkMessages TakeVtkMessages();

/// Throws a Failure "WHAT (first error)" if VTK reported an error since the last call, or a warning that amounts to one.
/// Other warnings are dropped.
void ThrowVtkErrors(const std::string& what);
}
