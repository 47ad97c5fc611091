// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// One clear sentence that ends a command, and the exit status that goes with it.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace penumbra::tool
{
/// What went wrong, as a sentence that names the thing and the remedy, without full stop handling.
class Failure : public std::runtime_error
{
public:
  enum Status
  {
    Failed = 1, ///< the input or the machine cannot do it
    Usage = 2   ///< the command line or scene file asks for something that does not exist
  };

  Failure(Status status, const std::string& sentence)
    : std::runtime_error(sentence)
    , ExitStatus(status)
  {
  }
  Status GetExitStatus() const { return this->ExitStatus; }

private:
  Status ExitStatus;
};

/// Ends the command with exit status 1.
template <typename... Args>
[[noreturn]] void Fail(fmt::format_string<Args...> text, Args&&... args)
{
  throw Failure(Failure::Failed, fmt::format(text, std::forward<Args>(args)...));
}

/// Ends the command with exit status 2.
template <typename... Args>
[[noreturn]] void FailUsage(fmt::format_string<Args...> text, Args&&... args)
{
  throw Failure(Failure::Usage, fmt::format(text, std::forward<Args>(args)...));
}
}
