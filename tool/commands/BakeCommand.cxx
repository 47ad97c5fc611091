// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake, and penumbra bake convert: lightmaps in the old format, OpenEXR, to VTK images.
#include "commands/BakeInput.h"
#include "commands/Commands.h"

#include "bake/lightmap/LightmapFile.h"
#include "common/Failure.h"
#include "common/Names.h"
#include "common/Windows.h"

#include <filesystem>

#include <unistd.h>

namespace penumbra::tool
{
namespace
{
class ConvertBake
{
public:
  CLI::App* Declare(CLI::App& bake)
  {
    CLI::App* command = bake.add_subcommand(
      "convert", "convert a lightmap in the old format, OpenEXR, to a VTK image");
    command->add_option("file", this->Input, "lightmap (.exr)")->required();
    command->add_option("-o,--output", this->Output, "the same lightmap (.vti)")->required();
    return command;
  }

  int Run(Console&)
  {
    RequireBakeFile(this->Output, ".vti", "lightmaps are written as VTK images");
    if (!lightmap::IsOpenExr(this->Input))
    {
      Fail("'{}' is not an OpenEXR file: give a lightmap in the old format", this->Input);
    }
    lightmap::WriteLightmap(this->Output, lightmap::ReadOldLightmap(this->Input));
    return 0;
  }

private:
  std::string Input;
  std::string Output;
};

void HideObjects(const BuiltScene& scene, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    bool found = false;
    std::vector<std::string> objects;
    for (const auto& [prop, object] : scene.Names)
    {
      objects.push_back(object);
      if (object == name)
      {
        prop->VisibilityOff();
        found = true;
      }
    }
    if (!found)
    {
      FailUsage("{}", UnknownName("object", name, "", objects));
    }
  }
}
}

void RequireBakeFile(const std::string& path, const char* extension, const char* reason)
{
  if (std::filesystem::path(path).extension() != extension)
  {
    FailUsage("'{}' does not end in {}: {}", path, extension, reason);
  }
  const auto folder = std::filesystem::path(path).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK) != 0 ||
    std::filesystem::is_directory(path))
  {
    Fail("'{}' cannot be written: choose another file with -o, in a folder you may write to", path);
  }
}

void BakeInput::DeclareExclusions(OptionGroup& group)
{
  group.Add("--without", this->Excluded,
    "leave out an object of the scene file, because it moves; may be repeated");
}

void BakeInput::Build(Console& console)
{
  console.SetQuiet(this->Options.Quiet);
  console.SetVerbose(this->Options.Verbose);
  this->Description = MakeScene(this->Options);
  this->Built = BuildScene(this->Description, this->Options.MaximumTriangles, console);
  HideObjects(this->Built, this->Excluded);
}

vtkSmartPointer<vtkRenderWindow> BakeInput::BuildInWindow(Console& console)
{
  const auto window = MakeWindow(this->Options.Backend);
  this->Build(console);
  ConfigureWindow(this->Description, this->Built, window);
  constexpr int side = 16; // nothing is drawn in it
  window->SetSize(side, side);
  window->SetMultiSamples(0);
  Step step(console, "opening an OpenGL window");
  OpenWindow(window);
  return window;
}

void AddBakeCommand(CLI::App& app, Console& console, int& status)
{
  CLI::App* bake = app.add_subcommand("bake", "compute light in advance, and store it in a file");
  bake->require_subcommand(1);
  bake->footer("Examples:\n"
               "  penumbra bake lightmap examples/cornell_lamp.json -o room.vti\n"
               "  penumbra bake probes examples/cornell_lamp.json -o probes.vti\n"
               "  penumbra bake radiosity examples/cornell.json -o cornell.vtp\n"
               "  penumbra bake radiosity --help");
  for (const auto add :
    { AddLightmapBake, AddProbeBake, AddRadiosityBake, AddCommand<ConvertBake> })
  {
    add(*bake, console, status);
  }
}
}
