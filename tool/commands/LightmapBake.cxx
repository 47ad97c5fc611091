// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake lightmap: indirect light on surfaces, stored in a texture atlas.
#include "commands/BakeInput.h"
#include "commands/Commands.h"
#include "commands/PassSetup.h"

#include "bake/lightmap/Bake.h"
#include "common/Failure.h"

namespace penumbra::tool
{
namespace
{
class LightmapBake
{
public:
  CLI::App* Declare(CLI::App& bake)
  {
    CLI::App* command = bake.add_subcommand(
      "lightmap", "indirect (and direct) light on static surfaces, stored in a texture atlas");
    command->add_option("-o,--output", this->Input.Options.Output, "lightmap (.vti)")->required();
    DeclareSceneOptions(*command, this->Input.Options);
    OptionGroup group(*command, "Lightmap");
    lightmap::BakeSettings& s = this->Settings;
    constexpr int rounds = lightmap::BakeSettings::Rounds;
    group.Add("--texel-size", s.TexelSize,
      "width of a texel, world units [1/128 of the scene's diagonal]", Bounds{ 0, 1e30 });
    group.AddShown("--max-size", s.LargestSide, "maximum width and height of the atlas, in texels",
      Bounds{ 16, 16384 });
    group.AddShown(
      "--samples", s.Samples, "paths per texel, a multiple of 16", Bounds{ rounds, 1e6 });
    group.AddShown("--bounces", s.Bounces, "maximum number of reflections", Bounds{ 1, 1000 });
    group.Flag(
      "--directional", s.Directional, "also store the direction of the light, for normal maps");
    group.Flag(
      "--direct", s.Direct, "also store direct light with its shadows; frames only add highlights");
    group.Flag("--no-denoise", this->Noisy, "do not remove the noise of few samples");
    group.Flag("--open-seams", this->OpenSeams, "do not remove steps between charts");
    this->Input.DeclareExclusions(group);
    group.Flag("--from-scratch", s.FromScratch, "ignore an earlier or interrupted bake");
    DeclareBackend(*command, this->Input.Options.Backend);
    command->footer(
      "Examples:\n"
      "  penumbra bake lightmap examples/cornell_lamp.json -o room.vti\n"
      "  penumbra bake lightmap room.json --direct --texel-size 0.01 -o room.vti\n"
      "  penumbra bake lightmap room.json --without robot --samples 1024 -o room.vti\n"
      "  penumbra render room.json --bake room.vti -o room.png");
    return command;
  }

  int Run(Console& console)
  {
    lightmap::BakeSettings& s = this->Settings;
    s.Output = this->Input.Options.Output;
    RequireBakeFile(s.Output, ".vti", "the lightmap is written as a VTK image");
    if (s.Samples % lightmap::BakeSettings::Rounds != 0)
    {
      FailUsage(
        "--samples is {}: it must be a multiple of {}", s.Samples, lightmap::BakeSettings::Rounds);
    }
    s.Denoise = !this->Noisy;
    s.CloseSeams = !this->OpenSeams;
    const auto window = this->Input.BuildInWindow(console);
    s.Names = this->Input.Built.Names;
    const Reflection reflection = ReflectionIn(this->Input.Description);
    s.MaximumAlbedo = reflection.MaximumAlbedo;
    s.EnergyCompensation = reflection.EnergyCompensation;
    const auto start = Clock::now();
    const auto result = lightmap::BakeLightmap(this->Input.Built.Renderer, s, console);
    this->Report(result, SecondsSince(start));
    window->Finalize();
    return 0;
  }

private:
  void Report(const lightmap::BakeResult& result, double seconds) const
  {
    const lightmap::Light& light = result.Map.Baked;
    if (!this->Input.Options.Statistics)
    {
      Print(fmt::format("{} x {} texels up to {:.3g} wide, {} charts; step across seams up "
                        "to {:.2g} %; {:.1f} s\n",
        light.Width, light.Height, result.TexelSize, result.Tiles, 100.0 * result.SeamStep,
        seconds));
      return;
    }
    const nlohmann::ordered_json report = { { "output", this->Input.Options.Output },
      { "width", light.Width }, { "height", light.Height }, { "texel-size", result.TexelSize },
      { "charts", result.Charts }, { "tiles", result.Tiles }, { "dark-sides", result.DarkSides },
      { "texels", result.Texels }, { "buried-texels", result.Buried },
      { "kept-tiles", result.KeptTiles }, { "resumed", result.Resumed },
      { "seam-step", result.SeamStep }, { "open-seam-step", result.OpenSeamStep },
      { "samples", this->Settings.Samples }, { "seconds", seconds } };
    Print(report.dump(2) + "\n");
  }

  BakeInput Input;
  lightmap::BakeSettings Settings;
  bool Noisy = false;
  bool OpenSeams = false;
};
}

void AddLightmapBake(CLI::App& bake, Console& console, int& status)
{
  AddCommand<LightmapBake>(bake, console, status);
}
}
