// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake NAME: light worked out beforehand, kept in a file.
#include "Command.h"

#include <CLI/CLI.hpp>

namespace penumbra::tool
{
namespace
{
class BakeCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command = app.add_subcommand("bake", "light worked out beforehand, kept in a file");
    command->require_subcommand(1);
    command->footer("Examples:\n"
                    "  penumbra bake radiosity examples/cornell.json -o cornell.vtp\n"
                    "  penumbra bake radiosity --help");
    for (auto make : { MakeRadiosityBake })
    {
      auto bake = make();
      CLI::App* options = bake->Declare(*command);
      this->Bakes.emplace_back(std::move(bake), options);
    }
    return command;
  }

  int Run(Console& console) override
  {
    for (const auto& [bake, options] : this->Bakes)
    {
      if (options->parsed())
      {
        return bake->Run(console);
      }
    }
    return 0;
  }

private:
  std::vector<std::pair<std::unique_ptr<Command>, CLI::App*>> Bakes;
};
}

std::unique_ptr<Command> MakeBakeCommand()
{
  return std::make_unique<BakeCommand>();
}
}
