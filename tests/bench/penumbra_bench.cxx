// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Compares frame times of the pass with those of stock VTK on the same scene. Frames are drawn in random order, so that
 * changes of the machine's speed affect all alike. Not measured: reading data, extracting the surface, compiling
 * shaders in the first frames, and reading back. Subcommands measure other costs.
 */
#include "FrameScenes.h"
#include "PassCost.h"
#include "ProbeCost.h"
#include "Report.h"
#include "SceneCost.h"

#include "vtkHeadlessRenderWindow.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace
{
struct FrameOptions
{
  std::string Volume = "/usr/share/mricron/templates/ch2.nii.gz";
  double Isovalue = 10.0; // mostly the skin
  std::string Json;
  bool Techniques = false;
  int Repetitions = 9;
  int Width = 1280;
  int Height = 720;
};

void Declare(CLI::App& app, FrameOptions& options)
{
  app.description(
    "Measures frame times of the pass and of stock VTK on an isosurface, and prints medians and "
    "ratios. Exits with 1 if a ratio is above its limit.");
  app.add_option("--volume", options.Volume, "a NIfTI volume (default: mricron-data's MRI head)");
  app.add_option("--isovalue", options.Isovalue, "value of the surface")->capture_default_str();
  app.add_flag("--techniques", options.Techniques,
    "measure the cost of each preset and technique instead of comparing with stock VTK");
  app.add_option("--json", options.Json, "also write the figures to this file");
  app.add_option("--repetitions", options.Repetitions, "frames per way of drawing")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  app.add_option("--width", options.Width, "pixels")->check(CLI::Range(16, 16384));
  app.add_option("--height", options.Height, "pixels")->check(CLI::Range(16, 16384));
}

CLI::App* Declare(CLI::App& app, bench::ProbeCostOptions& options)
{
  CLI::App* ddgi = app.add_subcommand("ddgi",
    "Measures updates of DDGI's probes instead, in a Cornell box with a moving lamp, for several "
    "numbers of probes, rays and triangles. Exits with 1 if the default update takes longer than "
    "--limit, if the cost per ray grows with their number, or if the cost grows faster than the "
    "logarithm of the triangles.");
  ddgi->add_option("--updates", options.Updates, "number of updates timed in each scene")
    ->check(CLI::Range(1, 10000))
    ->capture_default_str();
  ddgi->add_option("--most", options.Most, "triangles of the largest scene")
    ->check(CLI::Range(bench::LeastTriangles, 1e8))
    ->capture_default_str();
  ddgi->add_option("--limit", options.Limit, "maximum milliseconds of the default update")
    ->check(CLI::PositiveNumber);
  ddgi->add_option("--plot", options.Plot, "plot the cost over triangles to this PNG file");
  return ddgi;
}

CLI::App* Declare(CLI::App& app, bench::PassCostOptions& options)
{
  CLI::App* passes = app.add_subcommand("passes",
    "Measures each pass of a preset's frames instead, by timer queries on a GPU, or by the clock "
    "with software OpenGL. The options --volume, --isovalue, --repetitions, --width and --height "
    "come before the subcommand.");
  passes->add_option("--preset", options.Preset, "preset")->capture_default_str();
  passes->add_option(
    "--technique", options.Techniques, "switch a technique on, or off with a minus");
  passes->add_flag("--still", options.Still, "keep the camera still instead of turning it");
  return passes;
}

struct SceneOptions
{
  int Turns = 12;
  CLI::App* Lightmap = nullptr;
  CLI::App* Volumes = nullptr;
  CLI::App* Glyphs = nullptr;
};

void Declare(CLI::App& app, SceneOptions& options)
{
  options.Lightmap = app.add_subcommand("lightmap",
    "Measures the processor time that a lightmap adds to frames of 1280x720 instead. Exits with 1 "
    "if it is more than 5, 5 and 7 % in each of four tries.");
  options.Volumes = app.add_subcommand("volumes",
    "Measures the processor time that indirect light adds to a shaded volume instead. Exits with 1 "
    "if a frame takes more than 4 times as long with DDGI, or 6 times with baked probes, in each "
    "of "
    "four tries.");
  options.Glyphs = app.add_subcommand(
    "glyphs", "Measures the first frames of 302,500 glyphs instead, rasterized and path traced.");
  for (CLI::App* command : { options.Lightmap, options.Volumes })
  {
    command
      ->add_option("--turns", options.Turns, "number of frames with and without the light in a try")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  }
}

bool Run(const FrameOptions& options)
{
  const auto head = bench::ReadHead(options.Volume, options.Isovalue);
  std::vector<std::unique_ptr<bench::Stage>> stages;
  const auto variants = options.Techniques ? bench::TechniqueVariants() : bench::Variants();
  for (const auto& variant : variants)
  {
    stages.push_back(std::make_unique<bench::Stage>(variant, head, options.Width, options.Height));
    bench::Stage* stage = stages.back().get();
    stage->DrawFrame(); // compiles shaders
    stage->DrawFrame();
    benchmark::RegisterBenchmark(variant.Name.c_str(),
      [stage](benchmark::State& state) {
        for (auto _ : state)
        {
          state.SetIterationTime(stage->DrawFrame());
        }
      })
      ->UseManualTime()
      ->Iterations(1)
      ->Repetitions(options.Repetitions);
  }
  std::string name = "penumbra_bench";
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  char* arguments[] = { &name[0], &interleave[0], nullptr };
  int count = 2;
  benchmark::Initialize(&count, arguments);
  bench::Report report;
  benchmark::RunSpecifiedBenchmarks(&report);

  vtkNew<vtkHeadlessRenderWindow> window;
  window->Render();
  const std::string description = std::to_string(head->GetNumberOfPolys()) + " triangles, " +
    std::to_string(options.Width) + " x " + std::to_string(options.Height) + ", " +
    window->GetDescription() + ", median of " + std::to_string(options.Repetitions);
  if (options.Techniques)
  {
    return report.Conclude(bench::Costs(variants), {}, description, options.Json);
  }
  return report.Conclude({},
    {
      { "frame of the pass, techniques off / stock", "pass", "", "stock", "", 1.3 },
      { "added by occlusion of 32 samples / by vtkSSAOPass", "pass ssao", "pass", "stock ssao",
        "stock", 1.0 },
      { "added by a redrawn shadow map / by vtkShadowMapPass", "pass shadow", "pass",
        "stock shadow", "stock", 1.2 },
    },
    description, options.Json);
}
}

int main(int argc, char* argv[])
{
  FrameOptions frames;
  bench::ProbeCostOptions probes;
  CLI::App app;
  Declare(app, frames);
  const CLI::App* ddgi = Declare(app, probes);
  bench::PassCostOptions passes;
  const CLI::App* ofPasses = Declare(app, passes);
  SceneOptions scenes;
  Declare(app, scenes);
  CLI11_PARSE(app, argc, argv);
  try
  {
    if (ofPasses->parsed())
    {
      bench::ReportPassCost(passes, *bench::ReadHead(frames.Volume, frames.Isovalue), frames.Width,
        frames.Height, frames.Repetitions);
      return 0;
    }
    const bool good = ddgi->parsed() ? bench::ReportProbeCost(probes)
      : scenes.Lightmap->parsed()    ? bench::ReportLightmapCost(scenes.Turns)
      : scenes.Volumes->parsed()     ? bench::ReportVolumeCost(scenes.Turns)
      : scenes.Glyphs->parsed()      ? bench::ReportGlyphCost()
                                     : Run(frames);
    return good ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "penumbra_bench: %s\n", error.what());
    return 1;
  }
}
