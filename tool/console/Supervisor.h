// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Runs the command in a child process, to report a crash in a file reader or a driver in one sentence.
#pragma once

#include <functional>
#include <string>

namespace penumbra::tool
{
/// Runs a function in a child process and returns its exit status. If a signal ends the child, prints one sentence that
/// names its current stage, and returns 1. With PENUMBRA_NO_SUPERVISOR in the environment the function runs in this
/// process, for debuggers.
int Supervise(const std::function<int()>& run);

/// Sets the stage to report, such as "reading 'head.vti'"; "" for none.
void SetStage(const std::string& stage);

/// Limits the processor time that a supervised process may use from now on, in seconds; 0 for no limit.
void LimitProcessorTime(double seconds);
}
