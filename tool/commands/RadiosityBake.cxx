// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake radiosity: diffuse light between patches, once for all views.
#include "commands/BakeOptions.h"
#include "commands/OptionGroup.h"
#include "commands/RenderOptions.h"

#include "bake/radiosity/SceneSurfaces.h"
#include "bake/radiosity/SolutionFile.h"
#include "bake/radiosity/SolutionView.h"
#include "common/Failure.h"
#include "common/Names.h"
#include "image/Picture.h"
#include "scene/build/SceneBuilder.h"

#include <vtkGILightmap.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>
#include <optional>

namespace penumbra::tool
{
namespace
{
/// A step for each stage of the solution.
class StageSteps
{
public:
  explicit StageSteps(Console& console)
    : Target(console)
  {
  }
  ~StageSteps() { this->End(); }

  radiosity::Watch Watch()
  {
    radiosity::Watch watch;
    watch.Begin = [this](const std::string& what) {
      this->End();
      this->Current.emplace(this->Target, what);
    };
    watch.Advance = [this](double fraction) {
      if (this->Current)
      {
        this->Current->Advance(fraction);
      }
    };
    return watch;
  }
  void End() { this->Current.reset(); }

private:
  Console& Target;
  std::optional<Step> Current;
};

class RadiosityBake : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command = app.add_subcommand(
      "radiosity", "diffuse light between patches of the surfaces, the same from any view");
    command->add_option("-o,--output", this->Options.Output, "the solution (.vtp)")->required();
    DeclareSceneOptions(*command, this->Options);
    OptionGroup group(*command, "Radiosity");
    radiosity::Settings& s = this->Settings;
    group.Add("--patch-size", s.PatchSize,
      "longest edge of patches, world units [1/40 of the scene's diagonal]", Range{ 0, 1e30 });
    group.AddShown("--max-patches", s.MaximumPatches, "refuse to make more", Range{ 1, 1e8 });
    group.AddShown(
      "--rays", s.Rays, "from each side of a patch, for form factors", Range{ 1, 1e6 });
    group.AddShown(
      "--shadow-points", s.ShadowPoints, "of each patch, for direct light", Range{ 1, 1e4 });
    group.AddShown("--refine", s.Refinements, "times to halve patches where light changes steeply",
      Range{ 0, 8 });
    group.AddShown("--steepness", s.Steepness,
      "change of irradiance over a patch, of the mean, above which it is halved",
      Range{ 0.001, 1000 });
    group.AddShown("--solver", this->Solver, "gathering, shooting, or both, compared");
    group.AddShown("--tolerance", s.Tolerance, "residual to stop at, of the power first reflected",
      Range{ 1e-12, 0.5 });
    group.Flag("--one-way", this->OneWay, "leave form factors as traced, not reciprocal");
    group.Add("--view", this->View, "picture of the solution: .png, .jpg, .tif, .exr");
    group.Flag("--anew", this->Anew, "keep nothing of a solution that was broken off");
    group.Flag("--flat", this->Flat, "show patches in one colour each");
    command->footer(
      "Examples:\n"
      "  penumbra bake radiosity examples/cornell.json -o cornell.vtp --view cornell.png\n"
      "  penumbra bake radiosity room.json --patch-size 0.1 --rays 1024 -o room.vtp");
    return command;
  }

  int Run(Console& console) override
  {
    console.SetQuiet(this->Options.Quiet);
    console.SetVerbose(this->Options.Verbose);
    this->Check();
    const Scene scene = MakeScene(this->Options);
    const BuiltScene built = BuildScene(scene, { this->Options.MaximumTriangles }, console);
    radiosity::GatheredScene gathered = radiosity::GatherScene(built.Renderer);
    for (const std::string& note : gathered.Notes)
    {
      console.Note(note);
    }
    const auto start = std::chrono::steady_clock::now();
    radiosity::FactorLog log(this->Options.Output + ".baking", this->Identity(built), this->Anew);
    if (!log.Refusal().empty())
    {
      console.Note(
        fmt::format("'{}.baking' {}: tracing begins anew", this->Options.Output, log.Refusal()));
    }
    radiosity::Solution solution = this->Solve(std::move(gathered), log, console);
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    this->Comment(solution, console);
    {
      Step step(console, fmt::format("writing '{}'", this->Options.Output));
      this->Try([&] { radiosity::WriteSolution(this->Options.Output, solution); });
    }
    log.Remove();
    if (!this->View.empty())
    {
      this->Draw(solution, built, scene, console);
    }
    this->Report(solution, log.ShareTaken(), seconds);
    return 0;
  }

private:
  void Check()
  {
    radiosity::Settings& s = this->Settings;
    RequireBakeFile(this->Options.Output, ".vtp", "the solution is a VTK file of polygons");
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

  template <typename Work>
  static auto Try(const Work& work) -> decltype(work())
  {
    try
    {
      return work();
    }
    catch (const std::bad_alloc&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      Fail("{}", error.what());
    }
  }

  /// What form factors depend on beside where patches are: the rays, and what surrounds the scene.
  std::string Identity(const BuiltScene& built) const
  {
    return fmt::format(
      "{} rays of {}", this->Settings.Rays, vtkGILightmap::DescribeScene(built.Renderer));
  }

  radiosity::Solution Solve(
    radiosity::GatheredScene scene, radiosity::FactorLog& log, Console& console) const
  {
    StageSteps steps(console);
    return this->Try([&] {
      return radiosity::Solve(
        std::move(scene.Mesh), scene.Light, this->Settings, steps.Watch(), &log);
    });
  }

  static void Comment(const radiosity::Solution& solution, Console& console)
  {
    if (solution.SizeGrown)
    {
      console.Note(fmt::format(
        "patches are up to {:.3g} wide, to be few enough for --max-patches", solution.PatchSize));
    }
    if (solution.RefinementCut)
    {
      console.Note("steep places stay coarse: halving their patches would exceed --max-patches");
    }
    if (solution.EmissionByRays)
    {
      console.Note(
        "much of the scene shines and is found by chance: more --rays make its light smoother");
    }
  }

  void Draw(const radiosity::Solution& solution, const BuiltScene& built, const Scene& scene,
    Console& console) const
  {
    constexpr int samples = 16;
    Step step(console, fmt::format("drawing '{}'", this->View));
    Picture picture = radiosity::DrawSolution(solution, built.Renderer, scene.Width, scene.Height,
      samples, this->Flat, [&step](double fraction) { step.Advance(fraction); });
    if (!HoldsRadiance(this->View))
    {
      for (float& value : picture.Values)
      {
        value = static_cast<float>(radiosity::Display(value));
      }
    }
    WritePicture(this->View, picture);
  }

  void Report(const radiosity::Solution& solution, double taken, double seconds) const
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
    if (!this->Options.Statistics)
    {
      std::cout << fmt::format(
                     "{} patches, {} rays from each side; residual {:.2g} after {} steps; "
                     "irradiance is off by chance by {:.2g} % of its mean; {:.1f} s\n",
                     solution.Elements.size() / 2, solution.Matrix.Rays, residual,
                     chosen.History.size(), 100.0 * error, seconds)
                << std::flush;
      return;
    }
    nlohmann::ordered_json report = { { "output", this->Options.Output },
      { "patches", solution.Elements.size() / 2 }, { "patch-size", solution.PatchSize },
      { "rays", solution.Matrix.Rays }, { "factors", solution.Matrix.Entries.size() },
      { "form-factor-error", solution.FactorError }, { "irradiance-error", error },
      { "residual", residual }, { "resumed", taken }, { "seconds", seconds } };
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
    std::cout << report.dump(2) << std::endl;
  }

  RenderOptions Options;
  radiosity::Settings Settings;
  std::string Solver = "gathering";
  std::string View;
  bool OneWay = false;
  bool Flat = false;
  bool Anew = false;
};
}

std::unique_ptr<Command> MakeRadiosityBake()
{
  return std::make_unique<RadiosityBake>();
}
}
