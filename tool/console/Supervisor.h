// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Runs the command in a child process, so that a crash in a file reader or a driver becomes a sentence.
#pragma once

#include <functional>
#include <string>

namespace penumbra::tool
{
/// Runs work in a child process and returns its exit status. If the child is ended by a signal, prints
/// one sentence with the stage it had reached and returns 1. With PENUMBRA_NO_SUPERVISOR set the work
/// runs in this process, for debuggers.
int Supervise(const std::function<int()>& work);

/// Tells the supervising process what is being done: "reading 'head.vti'"; "" for nothing special.
void SetStage(const std::string& stage);

/// In a supervised process: lets the system stop it after so many further seconds of processor time; 0
/// lifts the limit.
void LimitProcessorTime(double seconds);
}
