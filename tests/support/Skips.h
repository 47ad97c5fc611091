// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A program of tests that skipped some, or all, says so: nobody takes them for passed.
#pragma once

namespace penumbra_test
{
/// What a program returns whose cases were all skipped; ctest knows it by SKIP_RETURN_CODE.
constexpr int AllSkipped = 77;

/// RUN_ALL_TESTS(), then a line "Skipped: NAME: REASON" for each case that was skipped, which ./run test lists and counts.
int RunTests();
}
