// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake convert: lightmaps in OpenEXR, as earlier versions wrote them, to files of today.
#include "commands/BakeOptions.h"

#include "bake/lightmap/OldLightmap.h"
#include "common/Failure.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace penumbra::tool
{
namespace
{
class ConvertBake : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command = app.add_subcommand(
      "convert", "a lightmap in OpenEXR, as it was written before, to a VTK image");
    command->add_option("file", this->Input, "the lightmap (.exr)")->required();
    command->add_option("-o,--output", this->Output, "the same lightmap (.vti)")->required();
    return command;
  }

  int Run(Console&) override
  {
    RequireBakeFile(this->Output, ".vti", "lightmaps are written as a VTK image");
    if (!std::filesystem::is_regular_file(this->Input))
    {
      Fail("the lightmap '{}' does not exist", this->Input);
    }
    if (!lightmap::IsOpenExr(this->Input))
    {
      Fail("'{}' is no OpenEXR file: only lightmaps in OpenEXR, of earlier versions, are converted",
        this->Input);
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
