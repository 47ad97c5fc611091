// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Options of a command under one heading of its help.
#pragma once

#include "common/Failure.h"
#include "scene/file/JsonObject.h"

#include <CLI/CLI.hpp>

#include <cstdlib>

namespace penumbra::tool
{
class OptionGroup
{
public:
  OptionGroup(CLI::App& command, const char* name)
    : Command(command)
    , Name(name)
  {
  }

  /// Adds an option with a value. An option for a vector is repeated, with one value each. A number out of bounds throws a
  /// Failure during parsing.
  template <typename T>
  CLI::Option* Add(
    const char* name, T& target, const std::string& help, std::optional<Bounds> bounds = {})
  {
    CLI::Option* option = this->Command.add_option(name, target, help)->group(this->Name);
    option->allow_extra_args(false);
    return !bounds ? option : option->check([option, bounds](const std::string& text) {
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      if (*end == '\0' && !(value >= bounds->Low && value <= bounds->High))
      {
        FailUsage("{} is {:g}: it must be from {:g} to {:g}", option->get_name(), value,
          bounds->Low, bounds->High);
      }
      return std::string(); // CLI11 reports what is not a number
    });
  }

  /// Adds an option whose help shows the current value of its target.
  template <typename T>
  CLI::Option* AddShown(
    const char* name, T& target, const std::string& help, std::optional<Bounds> bounds = {})
  {
    return this->Add(name, target, help, bounds)->capture_default_str();
  }

  CLI::Option* Flag(const char* name, bool& target, const std::string& help)
  {
    return this->Command.add_flag(name, target, help)->group(this->Name);
  }

private:
  CLI::App& Command;
  const char* Name;
};
}
