// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The subcommands of penumbra.
#pragma once

#include "console/Console.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>

namespace penumbra::tool
{
/// Each adds a command that sets the exit status when it runs, or throws a Failure.
void AddRenderCommand(CLI::App& app, Console& console, int& status);
void AddInfoCommand(CLI::App& app, Console& console, int& status);
void AddCompareCommand(CLI::App& app, Console& console, int& status);
void AddBakeCommand(CLI::App& app, Console& console, int& status);

/// Subcommands of bake.
void AddProbeBake(CLI::App& bake, Console& console, int& status);
void AddLightmapBake(CLI::App& bake, Console& console, int& status);
void AddRadiosityBake(CLI::App& bake, Console& console, int& status);

/// Adds a command whose options are members of an object: Declare() adds the subcommand, Run() returns the exit status.
template <typename Command>
void AddCommand(CLI::App& app, Console& console, int& status)
{
  auto command = std::make_shared<Command>();
  command->Declare(app)->callback([command, &console, &status] { status = command->Run(console); });
}

/// Prints a result on stdout at once, before anything else may fail.
inline void Print(const std::string& text)
{
  fmt::print("{}", text);
  std::fflush(stdout);
}

using Clock = std::chrono::steady_clock;

inline double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}
}
