// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace penumbra_test
{
/// Whether PENUMBRA_NIGHTLY asks for the full counts of a nightly run.
inline bool IsNightly()
{
  const char* value = std::getenv("PENUMBRA_NIGHTLY");
  return value && *value && std::string(value) != "0";
}
}
