// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The penumbra command: runs the subcommand and reports every failure in one sentence.
#include "commands/Commands.h"
#include "common/Failure.h"
#include "common/Names.h"
#include "common/VtkMessages.h"
#include "console/Supervisor.h"

namespace penumbra::tool
{
namespace
{
/// The innermost subcommand on the command line.
CLI::App* ActiveCommand(CLI::App& app)
{
  CLI::App* active = &app;
  while (!active->get_subcommands().empty())
  {
    active = active->get_subcommands().front();
  }
  return active;
}

/// "penumbra bake probes"
std::string FullName(const CLI::App* command)
{
  const CLI::App* parent = command->get_parent();
  return parent ? FullName(parent) + " " + command->get_name() : command->get_name();
}

std::vector<std::string> Subcommands(const CLI::App* command)
{
  std::vector<std::string> names;
  for (const CLI::App* subcommand : command->get_subcommands({}))
  {
    names.push_back(subcommand->get_name());
  }
  return names;
}

/// Reports an argument that CLI11 does not expect as a misspelt option or command.
std::string UnexpectedArgument(CLI::App& app)
{
  const CLI::App* active = ActiveCommand(app);
  const auto rest = app.remaining(true);
  const std::string name = rest.empty() ? "" : rest.front().substr(0, rest.front().find('='));
  const std::vector<std::string> commands = Subcommands(active);
  if (name.rfind("-", 0) != 0 && !commands.empty())
  {
    return UnknownName("command", name, "", commands);
  }
  std::vector<std::string> options;
  for (const CLI::Option* option : active->get_options())
  {
    for (const std::string& longName : option->get_lnames())
    {
      options.push_back("--" + longName);
    }
  }
  return UnknownName("option", name, "", options);
}

int ReportUsage(CLI::App& app, const CLI::ParseError& error, Console& console)
{
  if (error.get_exit_code() == 0)
  {
    return app.exit(error); // --help and --version
  }
  const CLI::App* active = ActiveCommand(app);
  const std::vector<std::string> commands = Subcommands(active);
  // If a command is missing, the first argument is a misspelt one.
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
    (!commands.empty() && !app.remaining(true).empty());
  std::string reason = unexpected ? UnexpectedArgument(app)
    : commands.empty()            ? error.what()
                                  : "name a command: " + Join(commands);
  reason.erase(reason.find_last_not_of(" .\n") + 1);
  console.Error(fmt::format("{}; see '{} --help'", reason, FullName(active)));
  return Failure::Usage;
}

/// Reports errors of VTK that did not stop the command, and prints warnings as notes.
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
  console.Error(
    fmt::format("VTK reports an error, so the result may be wrong: {}", messages.Errors.front()));
  return Failure::Failed;
}

/// Complains of empty arguments, which are most often unset variables of a shell.
void RequireArguments(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    if (argv[i][0] == '\0')
    {
      FailUsage("{}",
        i > 1 ? fmt::format("the argument after '{}' is empty", argv[i - 1])
              : "the first argument is empty");
    }
  }
}

int RunCommandLine(int argc, char** argv)
{
  Console console;
  int status = 0;
  CLI::App app(
    "Real-time global illumination for VTK data, with or without a GPU or a screen.", "penumbra");
  app.set_version_flag("--version", "penumbra " PENUMBRA_VERSION);
  app.require_subcommand(1);
  app.footer("Examples:\n"
             "  penumbra render head.nii.gz -o head.png\n"
             "  penumbra info --parameters\n"
             "  penumbra compare picture.png reference.png --max-relmse 0.01");
  for (const auto add : { AddRenderCommand, AddInfoCommand, AddCompareCommand, AddBakeCommand })
  {
    add(app, console, status);
  }
  try
  {
    RequireArguments(argc, argv);
    CollectVtkMessages();
    app.parse(argc, argv);
    return ReportLeftovers(status, console);
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
    console.Error("this machine has too little memory: use less data or a smaller picture");
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
