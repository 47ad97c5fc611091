// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake probes: indirect light in space, kept at the points of a grid.
#include "commands/BakeOptions.h"
#include "commands/OptionGroup.h"
#include "commands/RenderOptions.h"

#include "bake/BakeImage.h"
#include "common/Failure.h"
#include "common/Windows.h"
#include "scene/build/SceneBuilder.h"

#include <nlohmann/json.hpp>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkGIBakeFile.h>
#include <vtkGIProbeBaker.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace penumbra::tool
{
namespace
{
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class ProbeBake : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command =
      app.add_subcommand("probes", "indirect light in space, for what stands and what moves there");
    command->add_option("-o,--output", this->Options.Output, "the probes (.vti)")->required();
    DeclareSceneOptions(*command, this->Options);
    OptionGroup group(*command, "Probes");
    group.AddShown("--probes", this->Probes, "at most, around the scene",
      Range{ 27, vtkGIProbeBaker::MostProbes });
    CLI::Option* spacing = group.Add("--probe-spacing", this->Spacing,
      "between neighbours at most, world units, in place of --probes", Range{ 0, 1e30 });
    group.AddShown("--samples", this->Samples, "paths from each probe", Range{ 1, 1 << 24 });
    group.AddShown(
      "--bounces", this->Bounces, "reflections after which a path ends", Range{ 1, 10000 });
    CLI::Option* adaptive = group.Flag("--adaptive", this->Adaptive,
      "share the probes among a grid around the scene and finer ones where light needs them");
    CLI::Option* uniform =
      group.Flag("--uniform", this->Uniform, "leave probes where the grid puts them");
    adaptive->excludes(uniform)->excludes(spacing);
    group.Add("--without", this->Without,
      "an object of the scene file that moves, by its name; may be repeated");
    group.Flag("--anew", this->Anew, "keep nothing of a bake that was broken off");
    DeclareBackend(*command, this->Options.Backend);
    command->footer(
      "Examples:\n"
      "  penumbra bake probes examples/cornell_lamp.json -o room.vti\n"
      "  penumbra bake probes building.json --adaptive -o building.vti\n"
      "  penumbra bake probes room.json --without robot --probe-spacing 0.5 -o room.vti\n"
      "  penumbra render room.json --bake room.vti -o room.png");
    return command;
  }

  int Run(Console& console) override
  {
    console.SetQuiet(this->Options.Quiet);
    console.SetVerbose(this->Options.Verbose);
    RequireBakeFile(this->Options.Output, ".vti", "probes are written as a VTK image");
    const Scene scene = MakeScene(this->Options);
    const auto window = MakeWindow(this->Options.Backend);
    const BuiltScene built = BuildScene(scene, { this->Options.MaximumTriangles }, console);
    HideObjects(built, this->Without);
    OpenBakeWindow(scene, built, window, console);
    const auto start = Clock::now();
    vtkNew<vtkGIProbeBaker> baker;
    baker->SetProbes(this->Probes);
    baker->SetSpacing(this->Spacing);
    baker->SetAdaptive(this->Adaptive);
    baker->SetRelocate(!this->Uniform);
    baker->SetBounces(this->Bounces);
    vtkNew<vtkImageData> field;
    const int resumed = this->Begin(baker, built.Renderer, field, console);
    this->Gather(baker, built.Renderer, field, console);
    this->Comment(baker, console);
    vtkNew<vtkImageData> compact;
    Require(baker->Compact(field, compact), baker);
    Write(this->Options.Output, compact);
    std::error_code ignored;
    fs::remove(this->Partial(), ignored);
    this->Report(baker, field, resumed, SecondsSince(start));
    baker->ReleaseGraphicsResources(window);
    window->Finalize();
    return 0;
  }

private:
  static void Require(bool done, vtkGIProbeBaker* baker)
  {
    if (!done)
    {
      Fail("the probes cannot be baked: {}", baker->GetLastError());
    }
  }

  static void Write(const std::string& path, vtkImageData* field)
  {
    vtkNew<vtkGIBakeFile> file;
    if (!file->Write(path.c_str(), field))
    {
      Fail("{}", file->GetLastError());
    }
  }

  std::string Partial() const { return this->Options.Output + ".part"; }

  /// What a bake that was broken off must have been made with to be gone on with; its scene is kept beside.
  std::string Settings() const
  {
    return fmt::format("probes {} spacing {:.17g} bounces {} uniform {} adaptive {}", this->Probes,
      this->Spacing, this->Bounces, this->Uniform, this->Adaptive);
  }

  /// Places the probes, or takes them from a bake that was broken off. Returns the samples that these have.
  int Begin(
    vtkGIProbeBaker* baker, vtkRenderer* renderer, vtkImageData* field, Console& console) const
  {
    if (const int samples = this->Resume(baker, renderer, field, console))
    {
      return samples;
    }
    Step step(console, "placing probes");
    const ProgressWatch watch(baker, [&step](double share) { step.Advance(share); });
    Require(baker->Place(renderer, field), baker);
    SetText(field->GetFieldData(), "settings", this->Settings());
    return 0;
  }

  /// Returns 0 where there is nothing to go on with.
  int Resume(
    vtkGIProbeBaker* baker, vtkRenderer* renderer, vtkImageData* field, Console& console) const
  {
    if (this->Anew || !fs::exists(this->Partial()))
    {
      return 0;
    }
    vtkNew<vtkGIBakeFile> file;
    vtkNew<vtkImageData> partial;
    if (file->Read(this->Partial().c_str(), partial))
    {
      const int samples = baker->CountSamples(partial);
      const bool same = GetText(partial->GetFieldData(), "settings") == this->Settings() &&
        samples <= this->Samples && baker->Fits(renderer, partial);
      if (same && samples > 0)
      {
        field->ShallowCopy(partial);
        return samples;
      }
    }
    console.Note(
      fmt::format("'{}' is of another scene or of other settings, or damaged: the bake begins anew",
        this->Partial()));
    return 0;
  }

  void Gather(
    vtkGIProbeBaker* baker, vtkRenderer* renderer, vtkImageData* field, Console& console) const
  {
    // What is lost by a kill is what was gathered in so many seconds.
    constexpr double interval = 5.0;
    Step step(console, "gathering light");
    int part = 16;
    for (int done = baker->CountSamples(field); done < this->Samples;)
    {
      const int now = std::min(part, this->Samples - done);
      const auto start = Clock::now();
      {
        const ProgressWatch watch(
          baker, [&](double share) { step.Advance((done + share * now) / this->Samples); });
        Require(baker->AddSamples(renderer, field, now), baker);
      }
      done += now;
      SetText(field->GetFieldData(), "settings", this->Settings());
      const double factor = interval / std::max(SecondsSince(start), 1e-3);
      part = std::max(16, static_cast<int>(now * std::clamp(factor, 0.25, 4.0)) / 16 * 16);
      if (done < this->Samples)
      {
        Write(this->Partial(), field);
      }
    }
  }

  static void Comment(vtkGIProbeBaker* baker, Console& console)
  {
    if (const int lamps = baker->GetNumberOfLampsLeftOut())
    {
      console.Note(lamps == 1
          ? std::string("a lamp that follows the camera is left out: its light would not stay")
          : fmt::format(
              "{} lamps that follow the camera are left out: their light would not stay", lamps));
    }
    if (const int props = baker->GetNumberOfPropsLeftOut())
    {
      console.Note(props == 1
          ? std::string("an object is of a kind that rays do not see: it reflects no light")
          : fmt::format(
              "{} objects are of kinds that rays do not see: they reflect no light", props));
    }
  }

  struct Grid
  {
    std::array<int, 3> Counts;
    std::array<double, 6> Bounds;

    std::array<double, 3> Spacing() const
    {
      std::array<double, 3> spacing;
      for (int axis = 0; axis < 3; ++axis)
      {
        spacing[axis] =
          (this->Bounds[2 * axis + 1] - this->Bounds[2 * axis]) / (this->Counts[axis] - 1);
      }
      return spacing;
    }
  };

  static std::vector<Grid> GridsOf(vtkGIProbeBaker* baker, vtkImageData* field)
  {
    std::vector<Grid> grids(baker->CountGrids(field));
    for (std::size_t i = 0; i < grids.size(); ++i)
    {
      baker->GetGrid(field, static_cast<int>(i), grids[i].Counts.data(), grids[i].Bounds.data());
    }
    return grids;
  }

  void Report(vtkGIProbeBaker* baker, vtkImageData* field, int resumed, double seconds) const
  {
    constexpr double moved = 0.01; // of a cell
    const auto* offsets =
      vtkFloatArray::SafeDownCast(field->GetPointData()->GetArray("offset"))->GetPointer(0);
    const auto* backs =
      vtkUnsignedCharArray::SafeDownCast(field->GetPointData()->GetArray("backs"))->GetPointer(0);
    int away = 0;
    int behind = 0;
    for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
    {
      const float* o = offsets + 3 * i;
      away += std::hypot(o[0], o[1], o[2]) > moved;
      behind += backs[i] > 64;
    }
    const std::vector<Grid> grids = GridsOf(baker, field);
    if (!this->Options.Statistics)
    {
      std::string sizes;
      for (const Grid& grid : grids)
      {
        sizes += fmt::format("{}{} x {} x {}", sizes.empty() ? "" : " + ", grid.Counts[0],
          grid.Counts[1], grid.Counts[2]);
      }
      std::cout << fmt::format("{} probes, {} of them moved; {} samples each; {:.1f} s\n", sizes,
                     away, this->Samples, seconds)
                << std::flush;
      return;
    }
    nlohmann::ordered_json finer = nlohmann::ordered_json::array();
    for (std::size_t i = 1; i < grids.size(); ++i)
    {
      finer.push_back({ { "grid", grids[i].Counts }, { "spacing", grids[i].Spacing() },
        { "bounds", grids[i].Bounds } });
    }
    const nlohmann::ordered_json report = { { "output", this->Options.Output },
      { "grid", grids[0].Counts }, { "spacing", grids[0].Spacing() }, { "finer-grids", finer },
      { "probes", field->GetNumberOfPoints() }, { "moved", away }, { "behind-surfaces", behind },
      { "samples", this->Samples }, { "resumed-samples", resumed },
      { "bytes", fs::file_size(this->Options.Output) }, { "seconds", seconds } };
    std::cout << report.dump(2) << std::endl;
  }

  RenderOptions Options;
  int Probes = 1024;
  double Spacing = 0.0;
  int Samples = 1024;
  int Bounces = 64;
  bool Adaptive = false;
  bool Uniform = false;
  bool Anew = false;
  std::vector<std::string> Without;
};
}

std::unique_ptr<Command> MakeProbeBake()
{
  return std::make_unique<ProbeBake>();
}
}
