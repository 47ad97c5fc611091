// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// What VTK complains about. Each test fails on a warning or error that it did not expect.
#pragma once

#include <string>
#include <vector>

namespace penumbra_test
{
/// Collect VTK's warnings and errors instead of printing them, and fail the test that leaves one
/// behind. Call once, before the tests run.
void WatchMessages();

/// The warnings and errors since the test began or since the last call; they count as expected.
std::vector<std::string> TakeMessages();
}
