// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake radiosity: diffuse light between patches, independent of the view.
#include "commands/BakeInput.h"
#include "commands/Commands.h"
#include "commands/PassSetup.h"

#include "bake/radiosity/SceneSurfaces.h"
#include "bake/radiosity/SolutionFile.h"
#include "common/Failure.h"
#include "common/Names.h"

#include <vtkGILightmap.h>

namespace penumbra::tool
{
namespace
{
class RadiosityBake
{
public:
  CLI::App* Declare(CLI::App& bake)
  {
    CLI::App* command = bake.add_subcommand(
      "radiosity", "diffuse light between patches of the surfaces, independent of the view");
    command->add_option("-o,--output", this->Input.Options.Output, "solution (.vtp)")->required();
    DeclareSceneOptions(*command, this->Input.Options);
    OptionGroup group(*command, "Radiosity");
    radiosity::Settings& s = this->Settings;
    group.Add("--patch-size", s.PatchSize,
      "maximum edge length of a patch, world units [1/40 of the scene's diagonal]",
      Bounds{ 0, 1e30 });
    group.AddShown(
      "--max-patches", s.MaximumPatches, "maximum number of patches", Bounds{ 1, 1e8 });
    group.AddShown(
      "--rays", s.Rays, "rays per side of a patch, for form factors", Bounds{ 1, 1e6 });
    group.AddShown(
      "--shadow-points", s.ShadowPoints, "points per patch, for direct light", Bounds{ 1, 1e4 });
    group.AddShown("--refine", s.Refinements,
      "how often to halve patches where light changes steeply", Bounds{ 0, 8 });
    group.AddShown("--steepness", s.Steepness,
      "relative change of irradiance across a patch above which it is halved",
      Bounds{ 0.001, 1000 });
    group.AddShown("--solver", this->Solver, "gathering, shooting, or both, for comparison");
    group.AddShown("--tolerance", s.Tolerance,
      "final residual, relative to the power first reflected", Bounds{ 1e-12, 0.5 });
    group.Flag("--one-way", this->OneWay, "leave form factors as traced, not reciprocal");
    group.Add("--view", this->View, "picture of the solution: .png, .jpg, .tif, .exr");
    group.Flag("--from-scratch", this->FromScratch, "ignore an interrupted solution");
    group.Flag("--flat", this->Flat, "show each patch in a single colour");
    command->footer(
      "Examples:\n"
      "  penumbra bake radiosity examples/cornell.json -o cornell.vtp --view cornell.png\n"
      "  penumbra bake radiosity room.json --patch-size 0.1 --rays 1024 -o room.vtp");
    return command;
  }

  int Run(Console& console)
  {
    const std::string& output = this->Input.Options.Output;
    this->Check();
    this->Input.Build(console);
    vtkRenderer* renderer = this->Input.Built.Renderer;
    radiosity::GatheredScene scene = radiosity::GatherScene(
      renderer, ReflectionIn(this->Input.Description).MaximumAlbedo, console);
    const auto start = Clock::now();
    // Besides the patches, form factors depend on the number of rays and on the environment.
    const std::string identity =
      fmt::format("{} rays of {}", this->Settings.Rays, vtkGILightmap::DescribeScene(renderer));
    radiosity::FactorLog log(output + ".baking", identity, this->FromScratch);
    if (!log.Refusal().empty())
    {
      console.Note(
        fmt::format("'{}.baking' {}: tracing starts from scratch", output, log.Refusal()));
    }
    const radiosity::Solution solution =
      radiosity::Solve(std::move(scene.Mesh), scene.Light, this->Settings, console, &log);
    const double seconds = SecondsSince(start);
    NoteLimits(solution, console);
    {
      Step step(console, fmt::format("writing '{}'", output));
      radiosity::WriteSolution(output, solution);
    }
    log.Remove();
    if (!this->View.empty())
    {
      this->Draw(solution, console);
    }
    this->Report(solution, log.ReusedShare(), seconds);
    return 0;
  }

private:
  void Check()
  {
    radiosity::Settings& s = this->Settings;
    RequireBakeFile(
      this->Input.Options.Output, ".vtp", "the solution is written as VTK polygonal data");
    if (!this->View.empty())
    {
      RequireWritablePicture(this->View);
    }
    if (this->Solver != "gathering" && this->Solver != "shooting" && this->Solver != "both")
    {
      FailUsage("{}", UnknownName("solver", this->Solver, "", { "gathering", "shooting", "both" }));
    }
    s.Method =
      this->Solver == "shooting" ? radiosity::Solver::Shooting : radiosity::Solver::Gathering;
    s.Both = this->Solver == "both";
    s.Reciprocal = !this->OneWay;
  }

  static void NoteLimits(const radiosity::Solution& solution, Console& console)
  {
    if (solution.SizeGrown)
    {
      console.Note(
        fmt::format("patches are up to {:.3g} wide, because of --max-patches", solution.PatchSize));
    }
    if (solution.RefinementCut)
    {
      console.Note(
        "light changes steeply within some patches: halving them would exceed --max-patches");
    }
    if (solution.EmissionByRays)
    {
      console.Note(
        "much of the scene emits light, which is sampled at random: more --rays make it smoother");
    }
  }

  void Draw(const radiosity::Solution& solution, Console& console) const
  {
    constexpr int samples = 16;
    Step step(console, fmt::format("drawing '{}'", this->View));
    Picture picture =
      radiosity::DrawSolution(solution, this->Input.Built.Renderer, this->Input.Description.Width,
        this->Input.Description.Height, samples, this->Flat, step.GetProgress());
    if (!HoldsRadiance(this->View))
    {
      for (float& value : picture.Values)
      {
        value = static_cast<float>(radiosity::DisplayValue(value));
      }
    }
    WritePicture(this->View, picture);
  }

  void Report(const radiosity::Solution& solution, double reused, double seconds) const
  {
    const auto history = [](const radiosity::Reflected& solved) {
      nlohmann::ordered_json steps = nlohmann::json::array();
      for (const auto& step : solved.History)
      {
        steps.push_back({ step.Work, step.Residual });
      }
      return steps;
    };
    const radiosity::Reflected& chosen =
      this->Settings.Method == radiosity::Solver::Gathering ? solution.Gathered : solution.Shot;
    const double residual = chosen.History.empty() ? 0.0 : chosen.History.back().Residual;
    const double error = radiosity::RelativeError(solution);
    if (!this->Input.Options.Statistics)
    {
      Print(fmt::format("{} patches, {} rays from each side; residual {:.2g} after {} steps; "
                        "standard error of the irradiance {:.2g} % of its mean; {:.1f} s\n",
        solution.Elements.size() / 2, solution.Matrix.Rays, residual, chosen.History.size(),
        100.0 * error, seconds));
      return;
    }
    nlohmann::ordered_json report = { { "output", this->Input.Options.Output },
      { "patches", solution.Elements.size() / 2 }, { "patch-size", solution.PatchSize },
      { "rays", solution.Matrix.Rays }, { "factors", solution.Matrix.Entries.size() },
      { "form-factor-error", solution.FactorError }, { "irradiance-error", error },
      { "residual", residual }, { "resumed", reused }, { "seconds", seconds } };
    if (!solution.Gathered.Light.empty())
    {
      report["gathering"] = history(solution.Gathered);
    }
    if (!solution.Shot.Light.empty())
    {
      report["shooting"] = history(solution.Shot);
    }
    if (this->Settings.Both)
    {
      report["solvers-differ"] = radiosity::SolverDifference(solution);
    }
    Print(report.dump(2) + "\n");
  }

  BakeInput Input;
  radiosity::Settings Settings;
  std::string Solver = "gathering";
  std::string View;
  bool OneWay = false;
  bool Flat = false;
  bool FromScratch = false;
};
}

void AddRadiosityBake(CLI::App& bake, Console& console, int& status)
{
  AddCommand<RadiosityBake>(bake, console, status);
}
}
