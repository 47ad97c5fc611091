// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake lightmap: indirect light on surfaces, kept in a picture that is laid over them.
#include "commands/BakeOptions.h"
#include "commands/OptionGroup.h"
#include "commands/RenderOptions.h"

#include "bake/lightmap/Bake.h"
#include "common/Failure.h"
#include "common/Windows.h"
#include "scene/build/SceneBuilder.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>

namespace penumbra::tool
{
namespace
{
class LightmapBake : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command = app.add_subcommand(
      "lightmap", "indirect (and direct) light on still surfaces, in a picture laid over them");
    command->add_option("-o,--output", this->Options.Output, "the lightmap (.vti)")->required();
    DeclareSceneOptions(*command, this->Options);
    OptionGroup group(*command, "Lightmap");
    lightmap::BakeSettings& s = this->Settings;
    constexpr int rounds = lightmap::BakeSettings::Rounds;
    group.Add("--texel-size", s.TexelSize,
      "width of texels, world units [1/128 of the scene's diagonal]", Range{ 0, 1e30 });
    group.AddShown(
      "--max-size", s.LargestSide, "texels a side of the picture, at most", Range{ 16, 16384 });
    group.AddShown(
      "--samples", s.Samples, "paths from each texel, a multiple of 16", Range{ rounds, 1e6 });
    group.AddShown("--bounces", s.Bounces, "reflections after which a path ends", Range{ 1, 1000 });
    group.Flag("--directional", s.Directional,
      "keep where light comes from too, for normals that pictures bend");
    group.Flag("--direct", s.Lamps,
      "keep the lamps' own light too, with its shadows: frames add highlights alone");
    group.Flag("--no-denoise", this->Noisy, "leave the noise of few samples in");
    group.Flag("--open-seams", this->OpenSeams, "leave steps between charts as they are");
    group.Add("--without", this->Without,
      "an object of the scene file that moves, by its name; may be repeated");
    group.Flag("--anew", s.Anew, "keep nothing of an earlier bake, or of one that was broken off");
    DeclareBackend(*command, this->Options.Backend);
    command->footer(
      "Examples:\n"
      "  penumbra bake lightmap examples/cornell_lamp.json -o room.vti\n"
      "  penumbra bake lightmap room.json --direct --texel-size 0.01 -o room.vti\n"
      "  penumbra bake lightmap room.json --without robot --samples 1024 -o room.vti\n"
      "  penumbra render room.json --bake room.vti -o room.png");
    return command;
  }

  int Run(Console& console) override
  {
    console.SetQuiet(this->Options.Quiet);
    console.SetVerbose(this->Options.Verbose);
    this->Check();
    const Scene scene = MakeScene(this->Options);
    const auto window = MakeWindow(this->Options.Backend);
    const BuiltScene built = BuildScene(scene, { this->Options.MaximumTriangles }, console);
    HideObjects(built, this->Without);
    OpenBakeWindow(scene, built, window, console);
    const auto start = std::chrono::steady_clock::now();
    this->Settings.Names = built.Names;
    const lightmap::BakeResult result =
      lightmap::BakeLightmap(built.Renderer, this->Settings, console);
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    this->Report(result, seconds);
    window->Finalize();
    return 0;
  }

private:
  void Check()
  {
    lightmap::BakeSettings& s = this->Settings;
    RequireBakeFile(this->Options.Output, ".vti", "the lightmap is written as a VTK image");
    if (s.Samples % lightmap::BakeSettings::Rounds != 0)
    {
      FailUsage(
        "--samples is {}: it must be a multiple of {}", s.Samples, lightmap::BakeSettings::Rounds);
    }
    s.Denoise = !this->Noisy;
    s.CloseSeams = !this->OpenSeams;
    s.Output = this->Options.Output;
  }

  void Report(const lightmap::BakeResult& result, double seconds) const
  {
    const lightmap::Light& light = result.Map.Baked;
    if (!this->Options.Statistics)
    {
      std::cout << fmt::format("{} x {} texels up to {:.3g} wide, {} charts; step across seams at "
                               "most {:.2g} %; {:.1f} s\n",
                     light.Width, light.Height, result.TexelSize, result.Tiles,
                     100.0 * result.SeamStep, seconds)
                << std::flush;
      return;
    }
    const nlohmann::ordered_json report = { { "output", this->Options.Output },
      { "width", light.Width }, { "height", light.Height }, { "texel-size", result.TexelSize },
      { "charts", result.Charts }, { "tiles", result.Tiles }, { "dark-sides", result.DarkSides },
      { "texels", result.Texels }, { "buried-texels", result.Buried },
      { "kept-tiles", result.KeptTiles }, { "resumed", result.Resumed },
      { "seam-step", result.SeamStep }, { "open-seam-step", result.OpenSeamStep },
      { "samples", this->Settings.Samples }, { "seconds", seconds } };
    std::cout << report.dump(2) << std::endl;
  }

  RenderOptions Options;
  lightmap::BakeSettings Settings;
  std::vector<std::string> Without;
  bool Noisy = false;
  bool OpenSeams = false;
};
}

std::unique_ptr<Command> MakeLightmapBake()
{
  return std::make_unique<LightmapBake>();
}
}
