// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Warnings and errors of VTK. A test fails on each that it does not expect.
#pragma once

#include <string>
#include <vector>

namespace penumbra_test
{
/// Collect VTK's warnings and errors instead of printing them, and fail any test that does not take all of its own.
/// Call once, before the tests run.
void WatchMessages();

/// Take the warnings and errors since the start of the test or the last call. They count as expected.
std::vector<std::string> TakeMessages();
}
