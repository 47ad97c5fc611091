// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Reports of skipped tests, so that they are not taken for passed ones.
#pragma once

namespace penumbra_test
{
/// Exit status of a program that skipped all of its cases: ctest's SKIP_RETURN_CODE.
constexpr int AllSkipped = 77;

/// Call RUN_ALL_TESTS(), then print a line "Skipped: NAME: REASON" for each skipped case, which ./run test lists and
/// counts.
int RunTests();
}
