// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A command of the tool: declares its options, then runs.
#pragma once

#include "console/Console.h"

#include <memory>

namespace CLI
{
class App;
}

namespace penumbra::tool
{
class Command
{
public:
  virtual ~Command() = default;
  /// Adds a subcommand with options that write into this object; returns it.
  virtual CLI::App* Declare(CLI::App& app) = 0;
  /// Returns the exit status; throws a Failure.
  virtual int Run(Console& console) = 0;
};

std::unique_ptr<Command> MakeRenderCommand();
std::unique_ptr<Command> MakeInfoCommand();
std::unique_ptr<Command> MakeCompareCommand();
std::unique_ptr<Command> MakeBakeCommand();

/// Light worked out beforehand: subcommands of bake.
std::unique_ptr<Command> MakeProbeBake();
std::unique_ptr<Command> MakeLightmapBake();
std::unique_ptr<Command> MakeRadiosityBake();
std::unique_ptr<Command> MakeConvertBake();
}
