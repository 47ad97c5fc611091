// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra bake probes: indirect light in space, stored at the points of grids.
#include "commands/BakeInput.h"
#include "commands/Commands.h"
#include "commands/PassSetup.h"

#include "bake/BakeImage.h"
#include "common/Failure.h"

#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkGIBakeFile.h>
#include <vtkGIProbeBaker.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <filesystem>

namespace penumbra::tool
{
namespace
{
namespace fs = std::filesystem;

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

class ProbeBake
{
public:
  CLI::App* Declare(CLI::App& bake)
  {
    CLI::App* command =
      bake.add_subcommand("probes", "indirect light in space, for static and moving objects");
    command->add_option("-o,--output", this->Input.Options.Output, "probes (.vti)")->required();
    DeclareSceneOptions(*command, this->Input.Options);
    OptionGroup group(*command, "Probes");
    group.AddShown("--probes", this->Probes, "maximum number of probes around the scene",
      Bounds{ 27, vtkGIProbeBaker::MostProbes });
    CLI::Option* spacing = group.Add("--probe-spacing", this->Spacing,
      "maximum distance between neighbours, world units; replaces --probes", Bounds{ 0, 1e30 });
    group.AddShown("--samples", this->Samples, "paths per probe", Bounds{ 1, 1 << 24 });
    group.AddShown("--bounces", this->Bounces, "maximum number of reflections", Bounds{ 1, 10000 });
    CLI::Option* adaptive = group.Flag("--adaptive", this->Adaptive,
      "distribute the probes over a coarse grid and finer ones where light varies most");
    CLI::Option* uniform =
      group.Flag("--uniform", this->Uniform, "do not move probes off the points of the grid");
    adaptive->excludes(uniform)->excludes(spacing);
    this->Input.DeclareExclusions(group);
    group.Flag("--from-scratch", this->FromScratch, "ignore an interrupted bake");
    DeclareBackend(*command, this->Input.Options.Backend);
    command->footer(
      "Examples:\n"
      "  penumbra bake probes examples/cornell_lamp.json -o room.vti\n"
      "  penumbra bake probes building.json --adaptive -o building.vti\n"
      "  penumbra bake probes room.json --without robot --probe-spacing 0.5 -o room.vti\n"
      "  penumbra render room.json --bake room.vti -o room.png");
    return command;
  }

  int Run(Console& console)
  {
    RequireBakeFile(this->Input.Options.Output, ".vti", "probes are written as a VTK image");
    const auto window = this->Input.BuildInWindow(console);
    const auto start = Clock::now();
    vtkNew<vtkGIProbeBaker> baker;
    baker->SetProbes(this->Probes);
    baker->SetSpacing(this->Spacing);
    baker->SetAdaptive(this->Adaptive);
    baker->SetRelocate(!this->Uniform);
    baker->SetBounces(this->Bounces);
    const Reflection reflection = ReflectionIn(this->Input.Description);
    baker->SetMaximumAlbedo(reflection.MaximumAlbedo);
    baker->SetEnergyCompensation(reflection.EnergyCompensation);
    vtkNew<vtkImageData> field;
    const int resumed = this->Resume(baker, field, console);
    if (resumed == 0)
    {
      Step step(console, "placing probes");
      const ProgressObserver observer(baker, step.GetProgress());
      Require(baker->Place(this->Input.Built.Renderer, field), baker);
    }
    this->Gather(baker, field, console);
    NoteExclusions(baker, console);
    vtkNew<vtkImageData> compact;
    Require(baker->Compact(field, compact), baker);
    Write(this->Input.Options.Output, compact);
    std::error_code ignored;
    fs::remove(this->PartialFile(), ignored);
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

  std::string PartialFile() const { return this->Input.Options.Output + ".part"; }

  /// The settings that an interrupted bake must have been made with. Its image holds the scene.
  std::string Settings() const
  {
    const Reflection reflection = ReflectionIn(this->Input.Description);
    return fmt::format("probes {} spacing {:.17g} bounces {} uniform {} adaptive {} albedo {:.17g} {}",
      this->Probes, this->Spacing, this->Bounces, this->Uniform, this->Adaptive,
      reflection.MaximumAlbedo, reflection.EnergyCompensation);
  }

  /// Reads the field of an interrupted bake. Returns its number of samples, 0 if there is none to resume.
  int Resume(vtkGIProbeBaker* baker, vtkImageData* field, Console& console) const
  {
    if (this->FromScratch || !fs::exists(this->PartialFile()))
    {
      return 0;
    }
    vtkNew<vtkGIBakeFile> file;
    vtkNew<vtkImageData> partial;
    if (file->Read(this->PartialFile().c_str(), partial))
    {
      const int samples = baker->CountSamples(partial);
      const bool same = GetText(partial->GetFieldData(), "settings") == this->Settings() &&
        samples <= this->Samples && baker->Fits(this->Input.Built.Renderer, partial);
      if (same && samples > 0)
      {
        field->ShallowCopy(partial);
        return samples;
      }
    }
    console.Note(fmt::format(
      "'{}' is of another scene or of other settings, or damaged: the bake starts from scratch",
      this->PartialFile()));
    return 0;
  }

  void Gather(vtkGIProbeBaker* baker, vtkImageData* field, Console& console) const
  {
    constexpr double interval = 5.0; // seconds of work that a kill may lose
    Step step(console, "gathering light");
    int batch = 16;
    for (int samples = baker->CountSamples(field); samples < this->Samples;)
    {
      const int added = std::min(batch, this->Samples - samples);
      const auto start = Clock::now();
      {
        const ProgressObserver observer(
          baker, [&](double share) { step.Advance((samples + share * added) / this->Samples); });
        Require(baker->AddSamples(this->Input.Built.Renderer, field, added), baker);
      }
      samples += added;
      SetText(field->GetFieldData(), "settings", this->Settings());
      const double factor = interval / std::max(SecondsSince(start), 1e-3);
      batch = std::max(16, static_cast<int>(added * std::clamp(factor, 0.25, 4.0)) / 16 * 16);
      if (samples < this->Samples)
      {
        Write(this->PartialFile(), field);
      }
    }
  }

  static void NoteExclusions(vtkGIProbeBaker* baker, Console& console)
  {
    if (const int lights = baker->GetNumberOfLampsLeftOut())
    {
      console.Note(lights == 1
          ? std::string("a light that follows the camera is left out: it cannot be baked")
          : fmt::format(
              "{} lights that follow the camera are left out: they cannot be baked", lights));
    }
    if (const int props = baker->GetNumberOfPropsLeftOut())
    {
      console.Note(props == 1
          ? std::string("an object of a kind that ray tracing does not support reflects no light")
          : fmt::format(
              "{} objects of kinds that ray tracing does not support reflect no light", props));
    }
  }

  void Report(vtkGIProbeBaker* baker, vtkImageData* field, int resumed, double seconds) const
  {
    constexpr double moved = 0.01; // share of a cell
    const auto* offsets =
      vtkFloatArray::SafeDownCast(field->GetPointData()->GetArray("offset"))->GetPointer(0);
    const auto* backs =
      vtkUnsignedCharArray::SafeDownCast(field->GetPointData()->GetArray("backs"))->GetPointer(0);
    int relocated = 0;
    int behind = 0;
    for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
    {
      const float* o = offsets + 3 * i;
      relocated += std::hypot(o[0], o[1], o[2]) > moved;
      behind += backs[i] > 64;
    }
    std::vector<Grid> grids(baker->CountGrids(field));
    for (std::size_t i = 0; i < grids.size(); ++i)
    {
      baker->GetGrid(field, static_cast<int>(i), grids[i].Counts.data(), grids[i].Bounds.data());
    }
    if (!this->Input.Options.Statistics)
    {
      std::string sizes;
      for (const Grid& grid : grids)
      {
        sizes += fmt::format("{}{} x {} x {}", sizes.empty() ? "" : " + ", grid.Counts[0],
          grid.Counts[1], grid.Counts[2]);
      }
      Print(fmt::format("{} probes, {} of them moved; {} samples each; {:.1f} s\n", sizes,
        relocated, this->Samples, seconds));
      return;
    }
    nlohmann::ordered_json finer = nlohmann::ordered_json::array();
    for (std::size_t i = 1; i < grids.size(); ++i)
    {
      finer.push_back({ { "grid", grids[i].Counts }, { "spacing", grids[i].Spacing() },
        { "bounds", grids[i].Bounds } });
    }
    const nlohmann::ordered_json report = { { "output", this->Input.Options.Output },
      { "grid", grids[0].Counts }, { "spacing", grids[0].Spacing() }, { "finer-grids", finer },
      { "probes", field->GetNumberOfPoints() }, { "moved", relocated },
      { "behind-surfaces", behind }, { "samples", this->Samples }, { "resumed-samples", resumed },
      { "bytes", fs::file_size(this->Input.Options.Output) }, { "seconds", seconds } };
    Print(report.dump(2) + "\n");
  }

  BakeInput Input;
  int Probes = 1024;
  double Spacing = 0.0;
  int Samples = 1024;
  int Bounces = 64;
  bool Adaptive = false;
  bool Uniform = false;
  bool FromScratch = false;
};
}

void AddProbeBake(CLI::App& bake, Console& console, int& status)
{
  AddCommand<ProbeBake>(bake, console, status);
}
}
