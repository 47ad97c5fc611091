// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Skips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

namespace penumbra_test
{
namespace
{
// The reasons why a case was skipped, in one line.
std::string Reason(const testing::TestResult& result)
{
  std::string text;
  for (int i = 0; i < result.total_part_count(); ++i)
  {
    const testing::TestPartResult& part = result.GetTestPartResult(i);
    if (part.skipped())
    {
      text += (text.empty() ? "" : "; ") + std::string(part.message());
    }
  }
  text.erase(
    text.find_last_not_of('\n') + 1); // newer versions of GoogleTest end a message with one
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}
}

int RunTests()
{
  const int status = RUN_ALL_TESTS();
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
  {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j)
    {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (test.result()->Skipped())
      {
        std::cout << "Skipped: " << suite.name() << "." << test.name() << ": "
                  << Reason(*test.result()) << std::endl;
      }
    }
  }
  const bool skippedAll = all.skipped_test_count() > 0 && all.successful_test_count() == 0;
  return status == 0 && skippedAll ? AllSkipped : status;
}
}
