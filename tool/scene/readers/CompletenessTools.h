// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What the checks for complete files share.
#ifndef penumbra_tool_CompletenessTools_h
#define penumbra_tool_CompletenessTools_h

#include "common/Failure.h"

#include <filesystem>
#include <string>

namespace penumbra::tool
{
[[noreturn]] inline void FailShort(const std::string& path, double needed, double present)
{
  Fail("'{}' is cut off: its header asks for {:.0f} bytes and it has {:.0f}; copy or download it "
       "again",
    path, needed, present);
}

inline double FileSize(const std::string& path)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<double>(size);
}

inline std::string Trimmed(std::string text)
{
  text.erase(0, text.find_first_not_of(" \t\r"));
  text.erase(text.find_last_not_of(" \t\r") + 1);
  return text;
}
}

#endif
