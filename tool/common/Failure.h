// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Failures: one sentence for the user, and the exit status of the command.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace penumbra::tool
{
/// The sentence names the problem and the remedy, without a full stop.
class Failure : public std::runtime_error
{
public:
  enum Status
  {
    Failed = 1, ///< the input is unusable, or the machine is not capable of it
    Usage = 2   ///< the command line or the scene file is wrong
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

/// End the command with exit status 1.
template <typename... Args>
[[noreturn]] void Fail(fmt::format_string<Args...> text, Args&&... args)
{
  throw Failure(Failure::Failed, fmt::format(text, std::forward<Args>(args)...));
}

/// End the command with exit status 2.
template <typename... Args>
[[noreturn]] void FailUsage(fmt::format_string<Args...> text, Args&&... args)
{
  throw Failure(Failure::Usage, fmt::format(text, std::forward<Args>(args)...));
}
}
