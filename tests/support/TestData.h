// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files that tests read: in the source folder of the tests, or in the folder PENUMBRA_TEST_DATA.
 */
#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace penumbra_test
{
/// Full path of a file or folder, from its path relative to tests/.
inline std::string TestData(const std::string& relative)
{
  const char* folder = std::getenv("PENUMBRA_TEST_DATA");
  return std::string(folder ? folder : PENUMBRA_TEST_SOURCES) + "/" + relative;
}

/// The text of such a file.
inline std::string TestText(const std::string& relative)
{
  std::ifstream file(TestData(relative));
  if (!file)
  {
    throw std::runtime_error("The test's file " + relative + " cannot be read.");
  }
  return std::string((std::istreambuf_iterator<char>(file)), {});
}
}
