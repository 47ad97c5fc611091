// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files that tests read: in the source folder of the tests, or in the folder PENUMBRA_TEST_DATA.
 */
#pragma once

#include <cstdlib>
#include <string>

namespace penumbra_test
{
/// Full path of a file or folder, from its path relative to tests/.
inline std::string TestData(const std::string& relative)
{
  const char* folder = std::getenv("PENUMBRA_TEST_DATA");
  return std::string(folder ? folder : PENUMBRA_TEST_SOURCES) + "/" + relative;
}
}
