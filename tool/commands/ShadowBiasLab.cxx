// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra lab shadow-bias: shadow maps with more and more bias, beside the true shadow.
#include "commands/Command.h"
#include "commands/RenderOptions.h"

#include "common/Failure.h"
#include "common/Names.h"
#include "common/Windows.h"
#include "lab/BiasPlot.h"
#include "lab/BiasReport.h"
#include "lab/BiasSheet.h"
#include "lab/ShadowBench.h"
#include "scene/build/SceneBuilder.h"

#include <CLI/CLI.hpp>
#include <vtkGIShadowMaps.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace penumbra::tool
{
namespace
{
constexpr int LongestSide = 640; // of the picture unless asked for: a sweep draws dozens

class ShadowBiasLab : public Command
{
public:
  CLI::App* Declare(CLI::App& app) override
  {
    CLI::App* command = app.add_subcommand(
      "shadow-bias", "shadow maps with more and more bias: acne, peter-panning, what is safe");
    command->add_option("-o,--output", this->Options.Output, "folder for pictures and numbers")
      ->required();
    command->add_option("--bias", this->Kind, "constant, slope, normal, or all of them, each alone")
      ->capture_default_str();
    command->add_option("--from", this->From, "smallest bias, texels")->capture_default_str();
    command->add_option("--to", this->To, "greatest bias, texels")->capture_default_str();
    command->add_option("--steps", this->Steps, "biases to try")->capture_default_str();
    command->add_option(
      "--resolution", this->Resolution, "texels a side of the map [such that they are seen]");
    DeclareSceneOptions(*command, this->Options, "the scene's, at most 640 a side");
    command->footer(
      "Examples:\n"
      "  penumbra lab shadow-bias examples/shadow_bias.json -o bias\n"
      "  penumbra lab shadow-bias head.nii.gz --light key:elevation=30 --bias constant -o bias\n"
      "  penumbra lab shadow-bias scene.json --resolution 512 --to 4 --steps 9 --stats -o bias");
    return command;
  }

  int Run(Console& console) override
  {
    console.SetQuiet(this->Options.Quiet);
    console.SetVerbose(this->Options.Verbose);
    const BiasStudyOptions options = this->Plan();
    const Scene scene = this->Describe();
    const auto window = MakeWindow(this->Options.Backend);
    const BuiltScene built = BuildScene(scene, { this->Options.MaximumTriangles }, console);
    ConfigureWindow(scene, built, window);
    window->SetMultiSamples(0); // a mask has one value for each pixel
    built.Renderer->SetUseFXAA(false);
    {
      Step step(console, "opening an OpenGL window");
      OpenWindow(window);
    }
    nlohmann::ordered_json report;
    {
      ShadowBench bench(window, built.Renderer, scene.Techniques);
      this->MakeFolder();
      const BiasStudy study = StudyBias(bench, options, console);
      this->Comment(bench, study, console);
      report = this->Report(scene, study);
      this->Write(study, report, console);
      if (this->Options.Statistics)
      {
        std::cout << report.dump(2) << std::endl;
      }
      else
      {
        std::cout << SummarizeStudy(study) << std::flush;
      }
    }
    window->Finalize();
    return 0;
  }

private:
  Scene Describe() const
  {
    Scene scene = MakeScene(this->Options);
    const int longest = std::max(scene.Width, scene.Height);
    if (this->Options.Size.empty() && longest > LongestSide)
    {
      scene.Width = std::max(1, scene.Width * LongestSide / longest);
      scene.Height = std::max(1, scene.Height * LongestSide / longest);
    }
    return scene;
  }

  BiasStudyOptions Plan() const
  {
    vtkNew<vtkGIShadowMaps> maps; // for what it declares
    BiasStudyOptions options;
    const std::vector<std::string> kinds = BiasKinds(maps);
    if (this->Kind == "all")
    {
      options.Kinds = kinds;
    }
    else if (std::find(kinds.begin(), kinds.end(), this->Kind) != kinds.end())
    {
      options.Kinds = { this->Kind };
    }
    else
    {
      std::vector<std::string> known = kinds;
      known.emplace_back("all");
      FailUsage("{}", UnknownName("bias", this->Kind, "", known));
    }
    for (const std::string& kind : options.Kinds)
    {
      this->CheckRange(maps, kind);
    }
    options.Biases = EvenSteps(this->From, this->To, this->Steps);
    options.Resolution = this->CheckResolution(maps);
    return options;
  }

  void CheckRange(vtkGITechnique* maps, const std::string& kind) const
  {
    const auto [least, most] = Range(maps, kind + "-bias");
    if (!(this->From >= least && this->To <= most && this->From < this->To))
    {
      FailUsage("the bias cannot be swept from {:g} to {:g} texels: --from must be less than --to, "
                "and both from {:g} to {:g}",
        this->From, this->To, least, most);
    }
    constexpr int longest = 1000;
    if (this->Steps < 2 || this->Steps > longest)
    {
      FailUsage("--steps is {}: it must be from 2 to {}", this->Steps, longest);
    }
  }

  int CheckResolution(vtkGITechnique* maps) const
  {
    const auto [least, most] = Range(maps, "resolution");
    if (this->Resolution && !(*this->Resolution >= least && *this->Resolution <= most))
    {
      FailUsage("--resolution is {}: it must be from {:g} to {:g}", *this->Resolution, least, most);
    }
    return this->Resolution.value_or(0);
  }

  static std::pair<double, double> Range(vtkGITechnique* technique, const std::string& parameter)
  {
    for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
    {
      if (parameter == technique->GetParameterName(i))
      {
        return { technique->GetParameterMinimum(i), technique->GetParameterMaximum(i) };
      }
    }
    Fail("{} has no parameter '{}'", technique->GetName(), parameter);
  }

  void MakeFolder() const
  {
    std::error_code error;
    std::filesystem::create_directories(this->Options.Output, error);
    if (error || !std::filesystem::is_directory(this->Options.Output))
    {
      Fail("the folder '{}' cannot be made: choose another with -o, in a place you may write to",
        this->Options.Output);
    }
  }

  std::string File(const std::string& name) const
  {
    return (std::filesystem::path(this->Options.Output) / name).string();
  }

  void Comment(const ShadowBench& bench, const BiasStudy& study, Console& console) const
  {
    if (bench.OtherLamps() > 0)
    {
      console.Note(fmt::format("of {} lights that cast shadows the strongest is studied: give one "
                               "with --light for another",
        bench.OtherLamps() + 1));
    }
    if (bench.LeftOut() > 0)
    {
      console.Note(
        "what is translucent is left out: how dark its shadow is, is no matter of a bias");
    }
    constexpr double resolved = 0.5;
    if (study.PixelWidth > resolved)
    {
      console.Note(
        fmt::format("a pixel is {:.2g} texels wide, so that gaps narrower than that cannot "
                    "be told: come nearer with --camera zoom=2, or give a larger --size or "
                    "a smaller --resolution",
          study.PixelWidth));
    }
    if (study.LitPixels == 0)
    {
      console.Note("the light reaches nothing in view but edges, so that no acne can be seen");
    }
    if (study.ContactPoints + study.OutlinePoints == 0)
    {
      console.Note("no shadow is in view, so that no gap can be seen");
    }
  }

  nlohmann::ordered_json Report(const Scene& scene, const BiasStudy& study) const
  {
    nlohmann::ordered_json report = { { "input", this->Options.Files },
      { "size", { scene.Width, scene.Height } } };
    report.update(DescribeStudy(study));
    return report;
  }

  void Write(const BiasStudy& study, const nlohmann::ordered_json& report, Console& console) const
  {
    Step step(console, fmt::format("writing to '{}'", this->Options.Output));
    const Picture plot = DrawBiasPlot(study, this->Options.Backend, this->File("plot.svg"));
    WritePicture(this->File("plot.png"), plot);
    for (std::size_t i = 0; i < study.Sweeps.size(); ++i)
    {
      WritePicture(
        this->File(fmt::format("strip-{}.png", study.Sweeps[i].Kind)), DrawStrip(study, i));
    }
    WritePicture(this->File("sheet.png"), DrawSheet(study, plot));
    std::ofstream numbers(this->File("numbers.json"));
    numbers << report.dump(2) << '\n';
    if (!numbers.flush())
    {
      Fail("'{}' cannot be written: make room on the disk, or choose another folder with -o",
        this->File("numbers.json"));
    }
  }

  RenderOptions Options;
  std::string Kind = "all";
  double From = 0;
  double To = 4;
  int Steps = 17;
  std::optional<int> Resolution;
};
}

std::unique_ptr<Command> MakeShadowBiasLab()
{
  return std::make_unique<ShadowBiasLab>();
}
}
