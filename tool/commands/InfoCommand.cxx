// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Command.h"
#include "commands/TechniqueTable.h"

#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "common/Windows.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <vtkVersion.h>

#include <iostream>

namespace penumbra::tool
{
namespace
{
class InfoCommand : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command = app.add_subcommand("info", "OpenGL, VTK, and the table of techniques");
    command->add_flag("--parameters", this->Parameters, "each technique's parameters too");
    auto* json = command->add_flag("--json", this->Json, "for machines");
    command
      ->add_flag("--markdown", this->Markdown, "the tables for the documentation, without OpenGL")
      ->excludes(json);
    command->add_option("--backend", this->Backend, "egl, osmesa, x11 or auto")
      ->capture_default_str();
    command->footer("Examples:\n"
                    "  penumbra info\n"
                    "  penumbra info --parameters --backend osmesa\n"
                    "  penumbra info --json");
    return command;
  }

  int Run(Console& console) override
  {
    const auto techniques = DescribeTechniques();
    if (this->Markdown)
    {
      std::cout << MarkdownTable(techniques, this->Parameters);
      return 0;
    }
    nlohmann::ordered_json info = { { "penumbra", PENUMBRA_VERSION },
      { "vtk", vtkVersion::GetVTKVersion() }, { "opengl", nullptr }, { "techniques", techniques } };
    int status = 0;
    try
    {
      info["opengl"] = this->DescribeGraphics(console);
    }
    catch (const Failure& failure)
    {
      // The rest of the information holds without OpenGL too.
      console.Error(failure.what());
      status = failure.GetExitStatus();
      if (status == Failure::Usage)
      {
        return status;
      }
    }
    if (this->Json)
    {
      std::cout << info.dump(2) << std::endl;
      return status;
    }
    this->PrintVersions(info);
    std::cout << "\n" << PlainTable(techniques, this->Parameters);
    return status;
  }

private:
  nlohmann::ordered_json DescribeGraphics(Console& console)
  {
    vtkSmartPointer<vtkRenderWindow> window = MakeWindow(this->Backend);
    Step step(console, "opening an OpenGL window");
    const GraphicsInfo graphics = OpenWindow(window);
    window->Finalize();
    return { { "backend", graphics.Backend }, { "vendor", graphics.Vendor },
      { "renderer", graphics.Renderer }, { "version", graphics.Version } };
  }

  void PrintVersions(const nlohmann::ordered_json& info)
  {
    const auto line = [](const std::string& key, const std::string& value) {
      fmt::print("{:<16}{}\n", key, value);
    };
    line("Penumbra", PENUMBRA_VERSION);
    line("VTK", info["vtk"]);
    if (!info["opengl"].is_null())
    {
      line("backend", info["opengl"]["backend"]);
      line("OpenGL vendor", info["opengl"]["vendor"]);
      line("renderer", info["opengl"]["renderer"]);
      line("version", info["opengl"]["version"]);
    }
    std::fflush(stdout);
  }

  bool Parameters = false;
  bool Json = false;
  bool Markdown = false;
  std::string Backend = "auto";
};
}

std::unique_ptr<Command> MakeInfoCommand()
{
  return std::make_unique<InfoCommand>();
}
}
