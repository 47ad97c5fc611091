// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra lab NAME: experiments that make an error of a technique visible and measure it.
#include "Command.h"

#include <CLI/CLI.hpp>

namespace penumbra::tool
{
namespace
{
class LabCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command =
      app.add_subcommand("lab", "experiments: an error of a technique, made visible and measured");
    command->require_subcommand(1);
    command->footer("Examples:\n"
                    "  penumbra lab shadow-bias examples/shadow_bias.json -o bias\n"
                    "  penumbra lab shadow-bias --help");
    for (auto make : { MakeShadowBiasLab })
    {
      auto lab = make();
      CLI::App* options = lab->Declare(*command);
      this->Labs.emplace_back(std::move(lab), options);
    }
    return command;
  }

  int Run(Console& console) override
  {
    for (const auto& [lab, options] : this->Labs)
    {
      if (options->parsed())
      {
        return lab->Run(console);
      }
    }
    return 0;
  }

private:
  std::vector<std::pair<std::unique_ptr<Command>, CLI::App*>> Labs;
};
}

std::unique_ptr<Command> MakeLabCommand()
{
  return std::make_unique<LabCommand>();
}
}
