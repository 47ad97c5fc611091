// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Declares options of a command under one heading of its help.
#pragma once

#include "common/Failure.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::tool
{
/// Bounds of a number, included.
struct Range
{
  double Low;
  double High;
};

class OptionGroup
{
public:
  OptionGroup(CLI::App& command, const char* name)
    : Command(command)
    , Name(name)
  {
  }

  /// An option with a value. One that fills a vector is repeated, a value at a time. A number out of its range throws a
  /// Failure as the command line is parsed.
  template <typename T>
  CLI::Option* Add(
    const char* name, T& target, const std::string& help, std::optional<Range> range = {})
  {
    CLI::Option* option = this->Command.add_option(name, target, help)->group(this->Name);
    return Finish(option, target, range);
  }

  /// The same, whose help shows the value that the target has.
  template <typename T>
  CLI::Option* AddShown(
    const char* name, T& target, const std::string& help, std::optional<Range> range = {})
  {
    return this->Add(name, target, help, range)->capture_default_str();
  }

  CLI::Option* Flag(const char* name, bool& target, const std::string& help)
  {
    return this->Command.add_flag(name, target, help)->group(this->Name);
  }

private:
  template <typename T>
  static CLI::Option* Finish(CLI::Option* option, const std::vector<T>&, std::optional<Range> range)
  {
    return Check(option->allow_extra_args(false), range);
  }
  template <typename T>
  static CLI::Option* Finish(CLI::Option* option, const T&, std::optional<Range> range)
  {
    return Check(option, range);
  }

  static CLI::Option* Check(CLI::Option* option, std::optional<Range> range)
  {
    return !range ? option : option->check([option, range](const std::string& text) {
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      if (*end == '\0' && !(value >= range->Low && value <= range->High))
      {
        FailUsage("{} is {:g}: it must be from {:g} to {:g}", option->get_name(), value, range->Low,
          range->High);
      }
      return std::string(); // of what is no number, CLI11 says so
    });
  }

  CLI::App& Command;
  const char* Name;
};
}
