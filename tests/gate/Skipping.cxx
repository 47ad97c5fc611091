// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Cases for test_gate.py: two that are skipped, one that passes after much output, and one that fails.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

TEST(Absent, One)
{
  GTEST_SKIP() << "nothing of this\nkind here";
}

TEST(Absent, Other)
{
  GTEST_SKIP() << "nothing else";
}

TEST(Present, Talkative)
{
  std::cout << std::string(100000, '.') << std::endl;
}

TEST(Present, Broken)
{
  FAIL();
}
