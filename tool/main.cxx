// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The penumbra command: chooses the subcommand and turns every failure into one sentence.
#include "commands/Command.h"
#include "common/Failure.h"
#include "common/Names.h"
#include "common/VtkMessages.h"
#include "console/Supervisor.h"

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

/// The command that was named, or the command of a command.
CLI::App* Chosen(CLI::App& app)
{
  CLI::App* chosen = &app;
  while (!chosen->get_subcommands().empty())
  {
    chosen = chosen->get_subcommands().front();
  }
  return chosen;
}

/// "penumbra bake probes"
std::string FullName(const CLI::App* command)
{
  const CLI::App* parent = command->get_parent();
  return parent ? FullName(parent) + " " + command->get_name() : command->get_name();
}

std::vector<std::string> Subcommands(const CLI::App* scope)
{
  std::vector<std::string> names;
  for (const CLI::App* sub : scope->get_subcommands({}))
  {
    names.push_back(sub->get_name());
  }
  return names;
}

/// What CLI11 calls an unexpected argument, as a misspelt option or command.
std::string UnexpectedArgument(CLI::App& app)
{
  const CLI::App* scope = Chosen(app);
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
  const std::vector<std::string> commands = Subcommands(scope);
  const bool command = name.rfind("-", 0) != 0 && !commands.empty();
  return UnknownName(command ? "command" : "option", name, "", command ? commands : known);
}

int ReportUsage(CLI::App& app, const CLI::ParseError& error, Console& console)
{
  if (error.get_exit_code() == 0)
  {
    return app.exit(error); // --help and --version
  }
  const CLI::App* chosen = Chosen(app);
  const std::string help = FullName(chosen) + " --help";
  const std::vector<std::string> commands = Subcommands(chosen);
  // Where a command is missing the first argument is a misspelt one.
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
    (!commands.empty() && !app.remaining(true).empty());
  std::string reason = unexpected ? UnexpectedArgument(app)
    : commands.empty()            ? error.what()
                                  : "name a command: " + Join(commands);
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
  for (auto make : { MakeRenderCommand, MakeInfoCommand, MakeCompareCommand, MakeBakeCommand })
  {
    auto command = make();
    CLI::App* options = command->Declare(app);
    commands.push_back({ std::move(command), options });
  }
  try
  {
    app.parse(argc, argv);
    CollectVtkMessages();
    for (const Declared& command : commands)
    {
      if (command.Options->parsed())
      {
        return ReportLeftovers(command.Runner->Run(console), console);
      }
    }
  }
  catch (const CLI::ParseError& error)
  {
    return ReportUsage(app, error, console);
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
