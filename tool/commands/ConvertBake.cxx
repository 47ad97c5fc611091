// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake convert: lightmaps in the old form, OpenEXR, to VTK images.
#include "commands/BakeOptions.h"

#include "bake/lightmap/LightmapFile.h"
#include "common/Failure.h"

#include <CLI/CLI.hpp>

namespace penumbra::tool
{
namespace
{
class ConvertBake : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command =
      app.add_subcommand("convert", "a lightmap in the old form, OpenEXR, to a VTK image");
    command->add_option("file", this->Input, "the lightmap (.exr)")->required();
    command->add_option("-o,--output", this->Output, "the same lightmap (.vti)")->required();
    return command;
  }

  int Run(Console&) override
  {
    RequireBakeFile(this->Output, ".vti", "lightmaps are written as a VTK image");
    if (!lightmap::IsOpenExr(this->Input))
    {
      Fail("'{}' is not an OpenEXR file: give a lightmap in the old form", this->Input);
    }
    lightmap::WriteLightmap(this->Output, lightmap::ReadOldLightmap(this->Input));
    return 0;
  }

private:
  std::string Input;
  std::string Output;
};
}

std::unique_ptr<Command> MakeConvertBake()
{
  return std::make_unique<ConvertBake>();
}
}
