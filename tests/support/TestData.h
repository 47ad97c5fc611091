// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files that tests read: beside their sources, or where the environment says that they lie.
 */
#pragma once

#include <cstdlib>
#include <string>

namespace penumbra_test
{
/// The path of a file or folder below tests/.
inline std::string TestData(const std::string& below)
{
  const char* moved = std::getenv("PENUMBRA_TEST_DATA");
  return std::string(moved ? moved : PENUMBRA_TEST_SOURCES) + "/" + below;
}
}
