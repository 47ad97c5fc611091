// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Commands that hold commands: penumbra bake NAME.
#include "commands/Command.h"

#include <CLI/CLI.hpp>

namespace penumbra::tool
{
namespace
{
using Maker = std::unique_ptr<Command> (*)();

class CommandGroup : public Command
{
public:
  CommandGroup(
    std::string name, std::string description, std::string footer, std::vector<Maker> makers)
    : Name(std::move(name))
    , Description(std::move(description))
    , Footer(std::move(footer))
    , Makers(std::move(makers))
  {
  }

  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* group = app.add_subcommand(this->Name, this->Description);
    group->require_subcommand(1);
    group->footer(this->Footer);
    for (const Maker make : this->Makers)
    {
      auto command = make();
      CLI::App* options = command->Declare(*group);
      this->Commands.emplace_back(std::move(command), options);
    }
    return group;
  }

  int Run(Console& console) override
  {
    for (const auto& [command, options] : this->Commands)
    {
      if (options->parsed())
      {
        return command->Run(console);
      }
    }
    return 0;
  }

private:
  std::string Name;
  std::string Description;
  std::string Footer;
  std::vector<Maker> Makers;
  std::vector<std::pair<std::unique_ptr<Command>, CLI::App*>> Commands;
};
}

std::unique_ptr<Command> MakeBakeCommand()
{
  return std::make_unique<CommandGroup>("bake", "light worked out beforehand, kept in a file",
    "Examples:\n"
    "  penumbra bake lightmap examples/cornell_lamp.json -o room.vti\n"
    "  penumbra bake probes examples/cornell_lamp.json -o probes.vti\n"
    "  penumbra bake radiosity examples/cornell.json -o cornell.vtp\n"
    "  penumbra bake radiosity --help",
    std::vector<Maker>{ MakeLightmapBake, MakeProbeBake, MakeRadiosityBake, MakeConvertBake });
}
}
