// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The penumbra command: chooses the subcommand and turns every failure into one sentence.
#include "commands/Command.h"
#include "console/Supervisor.h"
#include "scene/Failure.h"
#include "scene/Names.h"
#include "scene/VtkMessages.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace penumbra::tool
{
namespace
{
struct Declared
{
  std::unique_ptr<Command> Runner;
  CLI::App* Options;
};

/// What CLI11 calls an unexpected argument, as a misspelt option or command.
std::string UnexpectedArgument(CLI::App& app)
{
  const auto chosen = app.get_subcommands();
  const CLI::App* scope = chosen.empty() ? &app : chosen.front();
  const auto rest = app.remaining(true);
  const std::string name = rest.empty() ? "" : rest.front().substr(0, rest.front().find('='));
  std::vector<std::string> known;
  for (const CLI::Option* option : scope->get_options())
  {
    for (const std::string& longName : option->get_lnames())
    {
      known.push_back("--" + longName);
    }
  }
  const bool command = name.rfind("-", 0) != 0 && chosen.empty();
  if (command)
  {
    known.clear();
    for (const CLI::App* sub : app.get_subcommands({}))
    {
      known.push_back(sub->get_name());
    }
  }
  return UnknownName(command ? "command" : "option", name, "", known);
}

int ReportUsage(CLI::App& app, const CLI::ParseError& error, Console& console)
{
  if (error.get_exit_code() == 0)
  {
    return app.exit(error); // --help and --version
  }
  const auto chosen = app.get_subcommands();
  const std::string help = chosen.empty()
    ? "penumbra --help"
    : fmt::format("penumbra {} --help", chosen.front()->get_name());
  // Without a command the first argument is a misspelt one.
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
    (chosen.empty() && !app.remaining().empty());
  std::string reason = unexpected ? UnexpectedArgument(app) : error.what();
  reason = chosen.empty() && !unexpected ? "name a command: render, info, compare or lab" : reason;
  reason.erase(reason.find_last_not_of(" .\n") + 1);
  console.Error(fmt::format("{}; '{}' lists what there is", reason, help));
  return Failure::Usage;
}

/// Errors that VTK reported without stopping the command count too; warnings become notes.
int ReportLeftovers(int status, Console& console)
{
  const VtkMessages messages = TakeVtkMessages();
  for (const std::string& warning : messages.Warnings)
  {
    console.Note(warning);
  }
  if (messages.Errors.empty())
  {
    return status;
  }
  console.Error(fmt::format(
    "VTK reports an error, so that the result may be wrong: {}", messages.Errors.front()));
  return Failure::Failed;
}

/// An unset variable of a shell, most often: no option and no file has an empty value.
std::string FindEmptyArgument(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    if (argv[i][0] == '\0')
    {
      return i > 1 ? fmt::format("the argument after '{}' is empty", argv[i - 1])
                   : "the first argument is empty";
    }
  }
  return "";
}

int RunCommandLine(int argc, char** argv)
{
  Console console;
  if (const std::string empty = FindEmptyArgument(argc, argv); !empty.empty())
  {
    console.Error(empty);
    return Failure::Usage;
  }
  CLI::App app(
    "Real-time global illumination for VTK data, with or without a GPU or a screen.", "penumbra");
  app.set_version_flag("--version", "penumbra " PENUMBRA_VERSION);
  app.require_subcommand(1);
  app.footer("Examples:\n"
             "  penumbra render head.nii.gz -o head.png\n"
             "  penumbra info --parameters\n"
             "  penumbra compare picture.png reference.png --max-relmse 0.01");
  std::vector<Declared> commands;
  for (auto make : { MakeRenderCommand, MakeInfoCommand, MakeCompareCommand, MakeLabCommand })
  {
    auto command = make();
    CLI::App* options = command->Declare(app);
    commands.push_back({ std::move(command), options });
  }
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return ReportUsage(app, error, console);
  }
  CollectVtkMessages();
  try
  {
    for (const Declared& command : commands)
    {
      if (command.Options->parsed())
      {
        return ReportLeftovers(command.Runner->Run(console), console);
      }
    }
  }
  catch (const Failure& failure)
  {
    console.Error(failure.what());
    return failure.GetExitStatus();
  }
  catch (const std::bad_alloc&)
  {
    console.Error(
      "this machine has too little memory for that: use less data or a smaller picture");
  }
  catch (const std::exception& error)
  {
    console.Error(fmt::format("unexpected failure: {}", error.what()));
  }
  return Failure::Failed;
}
}
}

int main(int argc, char** argv)
{
  return penumbra::tool::Supervise([&] { return penumbra::tool::RunCommandLine(argc, argv); });
}
