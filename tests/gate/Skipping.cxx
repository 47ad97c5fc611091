// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// What test_gate.py has ctest run: cases that are skipped, and one that is not.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

TEST(Absent, One)
{
  GTEST_SKIP() << "no thing of this\nkind here";
}

TEST(Absent, Other)
{
  GTEST_SKIP() << "no other thing";
}

TEST(Present, Talkative)
{
  std::cout << std::string(100000, '.') << std::endl;
}

TEST(Present, Broken)
{
  FAIL();
}
