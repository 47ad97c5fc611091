// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra render: a picture of data files or a scene file.
#include "commands/Checkpoint.h"
#include "commands/Commands.h"
#include "commands/Flight.h"
#include "commands/PassSetup.h"
#include "commands/RenderOptions.h"

#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "common/Windows.h"
#include "image/Capture.h"
#include "image/FrameChartFile.h"
#include "scene/build/SceneBuilder.h"

#include <fmt/ranges.h>
#include <vtkCamera.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRendererCollection.h>
#include <vtkTextureObject.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

#include <unistd.h>

namespace penumbra::tool
{
namespace
{
/// Colour, depth, eight samples, G-buffer, histories, and a float copy for the file.
constexpr double BytesPerPixel = 250;

void RequireDrawableSize(const Scene& scene, vtkRenderWindow* window)
{
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  const int largest = glWindow ? vtkTextureObject::GetMaximumTextureSize(glWindow) : -1;
  if (largest > 0 && std::max(scene.Width, scene.Height) > largest)
  {
    Fail("a picture of {}x{} is too big: this OpenGL draws up to {} pixels a side", scene.Width,
      scene.Height, largest);
  }
  const double needed = BytesPerPixel * scene.Width * scene.Height;
  const double memory = double(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
  if (needed > memory)
  {
    Fail("a picture of {}x{} is too big: it needs about {:.0f} GB of memory and there are {:.0f}",
      scene.Width, scene.Height, needed / 1e9, memory / 1e9);
  }
}

/// Visits the enabled techniques, and after the first frame those that stand in for them.
template <typename Visit>
void ForEachActive(vtkGIPass* pass, const Visit& visit)
{
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    if (pass->GetTechnique(i)->GetEnabled() || pass->GetTechnique(i)->GetTookPart())
    {
      visit(pass->GetTechnique(i));
    }
  }
}

int RequiredFrames(const Scene& scene, vtkGIPass* pass)
{
  int frames = scene.Frames;
  ForEachActive(pass, [&frames](vtkGITechnique* technique) {
    const int required = technique->GetRequiredFrames();
    frames = required > 1 ? required : frames;
  });
  return frames;
}

bool IsFinished(vtkGIPass* pass, vtkRenderer* renderer)
{
  bool finished = true;
  ForEachActive(pass,
    [&](vtkGITechnique* technique) { finished = finished && technique->IsFinished(renderer); });
  return finished;
}

class RenderCommand
{
public:
  CLI::App* Declare(CLI::App& app)
  {
    CLI::App* command =
      app.add_subcommand("render", "render data files or a scene file to a picture");
    DeclareRenderOptions(*command, this->Options);
    this->Declared = command;
    return command;
  }

  int Run(Console& console)
  {
    console.SetQuiet(this->Options.Quiet);
    console.SetVerbose(this->Options.Verbose);
    const Scene scene = MakeScene(this->Options);
    RequireWritablePicture(this->Options.Output);
    this->CheckStock();
    if (!this->Options.StatisticsPlot.empty())
    {
      RequireChartName(this->Options.StatisticsPlot);
    }
    const auto start = Clock::now();
    vtkSmartPointer<vtkRenderWindow> window = MakeWindow(this->Options.Backend);
    vtkNew<vtkGIPass> pass;
    if (!this->Options.Stock)
    {
      SetUpPass(scene, pass, console);
    }
    this->CheckTracing(pass);
    this->CheckBudget(pass);
    const BuiltScene built = BuildScene(scene, this->Options.MaximumTriangles, console);
    ApplyLook(scene, built.Renderer, this->Options.Stock ? nullptr : pass.Get(), console);
    ConfigureWindow(scene, built, window);
    this->Report["scene-ms"] = 1e3 * SecondsSince(start);
    {
      Step step(console, "opening an OpenGL window");
      this->Report["opengl"] = OpenWindow(window);
      RequireDrawableSize(scene, window);
    }
    if (!this->Options.Stock)
    {
      pass->SetKeepRadiance(HoldsRadiance(this->Options.Output));
      pass->SetCollectStatistics(this->Options.Statistics || !this->Options.StatisticsPlot.empty());
      pass->SetFrameBudget(this->Options.Budget.value_or(0.0));
      built.Renderer->SetPass(pass);
    }
    this->Draw(window, built, pass, scene, console);
    this->Write(built.Renderer, pass, scene, console);
    this->ReportScene(scene, built, pass);
    this->WritePlot(pass);
    if (this->Options.Statistics)
    {
      Print(this->Report.dump(2) + "\n");
    }
    window->Finalize();
    return 0;
  }

private:
  void CheckStock() const
  {
    if (this->Options.Stock && (this->Options.Budget || !this->Options.StatisticsPlot.empty()))
    {
      FailUsage("{} is for Penumbra's frames: leave out --stock",
        this->Options.Budget ? "--budget" : "--stats-plot");
    }
  }

  void CheckBudget(vtkGIPass* pass) const
  {
    if (this->Options.Budget && pass->GetTechnique("path-tracing")->GetEnabled())
    {
      FailUsage("--budget is for moving pictures, and the path tracer makes still ones: choose "
                "another preset");
    }
  }

  void WritePlot(vtkGIPass* pass) const
  {
    if (!this->Options.StatisticsPlot.empty())
    {
      WriteFrameChart(
        this->Options.StatisticsPlot, pass->GetStatistics(), 1200, 500, this->Options.Backend);
    }
  }

  void CheckTracing(vtkGIPass* pass)
  {
    const char* option = this->Options.Samples ? "--spp"
      : this->Options.Error                    ? "--error"
      : !this->Options.Checkpoint.empty()      ? "--checkpoint"
      : this->Options.Denoise                  ? "--denoise"
                                               : nullptr;
    if (option && (this->Options.Stock || !pass->GetTechnique("path-tracing")->GetEnabled()))
    {
      FailUsage("{} is for the path tracer, which is off: give --preset reference or "
                "--on path-tracing",
        option);
    }
  }

  /// Renders the frames. Stock VTK's are identical, so one is enough.
  void Draw(vtkRenderWindow* window, const BuiltScene& built, vtkGIPass* pass, const Scene& scene,
    Console& console)
  {
    const bool repeat = !this->Options.Stock || this->Options.Frames;
    int frames = !repeat ? 1 : scene.FramesGiven ? scene.Frames : RequiredFrames(scene, pass);
    frames = this->Options.Budget && !scene.FramesGiven ? FlightFrames : frames;
    vtkRenderer* renderer = window->GetRenderers()->GetFirstRenderer();
    std::optional<Checkpoint> checkpoint;
    if (!this->Options.Checkpoint.empty())
    {
      checkpoint.emplace(
        this->Options.Checkpoint, this->Identity(scene, built, pass), pass, renderer);
      frames = std::max(1, frames - checkpoint->Resume());
    }
    Step step(console, fmt::format("rendering '{}'", this->Options.Output));
    std::optional<Flight> flight;
    if (this->Options.Budget)
    {
      flight.emplace(renderer);
    }
    std::vector<double> times;
    for (int frame = 0;
         frame < frames && (flight || frame < scene.Frames || !IsFinished(pass, renderer)); ++frame)
    {
      if (flight)
      {
        flight->Place(frames - 1 - frame);
      }
      const auto start = Clock::now();
      window->Render();
      window->WaitForCompletion();
      times.push_back(1e3 * SecondsSince(start));
      step.Advance(double(frame + 1) / frames);
      ThrowVtkErrors("rendering failed");
      const char* error = this->Options.Stock ? nullptr : pass->GetLastError();
      if (error && *error)
      {
        Fail("rendering failed: {}", error);
      }
      if (frame == 0 && !this->Options.Stock)
      {
        this->ReportNotes(pass, console);
        // Techniques that stand in for others are known only now.
        frames = scene.FramesGiven || checkpoint || flight ? frames : RequiredFrames(scene, pass);
      }
      if (checkpoint)
      {
        checkpoint->SaveIfDue();
      }
    }
    if (checkpoint)
    {
      checkpoint->Save();
    }
    this->Report["frames"] = times.size();
    this->Report["first-frame-ms"] = times.front();
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    this->Report["median-frame-ms"] = times[times.size() / 2];
  }

  /// Fingerprint of the options that change the picture, and of the files' content.
  std::string InputFingerprint() const
  {
    std::string text;
    const std::set<std::string> others = { "--output", "--spp", "--error", "--checkpoint",
      "--frames", "--stats", "--stats-plot", "--quiet", "--verbose", "--backend", "--help",
      "--denoise" };
    for (const CLI::Option* option : this->Declared->get_options())
    {
      if (option->count() > 0 && others.count(option->get_name()) == 0)
      {
        text += fmt::format("{}={};", option->get_name(), fmt::join(option->results(), " "));
      }
    }
    std::vector<std::string> files = this->Options.Files;
    files.push_back(this->Options.Environment);
    return Fingerprint(text, files);
  }

  /// Description of the picture that a checkpoint is for.
  std::string Identity(const Scene& scene, const BuiltScene& built, vtkGIPass* pass) const
  {
    vtkCamera* camera = built.Renderer->GetActiveCamera();
    const auto list = [](const double* v) {
      return fmt::format("{:.6g} {:.6g} {:.6g}", v[0], v[1], v[2]);
    };
    vtkGITechnique* tracer = pass->GetTechnique("path-tracing");
    return fmt::format(
      "{}x{} pixels, {} triangles and {} balls in {}, {} lights, seen from {} to {} "
      "at {:.6g} degrees, {} bounces (options and files {})",
      scene.Width, scene.Height, built.Triangles, built.Balls, fmt::join(this->Options.Files, " "),
      built.Renderer->GetLights()->GetNumberOfItems(), list(camera->GetPosition()),
      list(camera->GetFocalPoint()), camera->GetViewAngle(), tracer->GetParameter("bounces"),
      this->InputFingerprint());
  }

  /// Prints the techniques' notes on the scene. They are the same in every frame.
  void ReportNotes(vtkGIPass* pass, Console& console)
  {
    nlohmann::json notes = nlohmann::json::array();
    std::istringstream lines(pass->GetNotes());
    for (std::string line; std::getline(lines, line);)
    {
      console.Note(line);
      notes.push_back(line);
    }
    this->Report["notes"] = notes;
  }

  void Write(vtkRenderer* renderer, vtkGIPass* pass, const Scene& scene, Console& console)
  {
    const bool alpha = scene.Backdrop && scene.Backdrop->Transparent;
    const bool radiance = HoldsRadiance(this->Options.Output) && !this->Options.Stock;
    Picture picture;
    {
      Step step(console, fmt::format("writing '{}'", this->Options.Output));
      vtkRenderWindow* window = renderer->GetRenderWindow();
      const auto redraw = [&] {
        for (int frame = 0; frame < scene.Frames; ++frame)
        {
          window->Render();
        }
      };
      picture =
        radiance ? CaptureRadiance(pass, renderer, alpha, redraw) : CaptureWindow(window, alpha);
      if (radiance && HoldsLayers(this->Options.Output))
      {
        AppendSurfaceLayers(pass, renderer, picture);
      }
    }
    if (const std::size_t bad = RemoveNonFinite(picture))
    {
      console.Note(fmt::format("{} pixels were not finite and are written as 0", bad));
    }
    WritePicture(this->Options.Output, picture);
  }

  void ReportScene(const Scene& scene, const BuiltScene& built, vtkGIPass* pass)
  {
    this->Report["output"] = this->Options.Output;
    this->Report["size"] = { scene.Width, scene.Height };
    this->Report["triangles"] = built.Triangles;
    this->Report["balls"] = built.Balls;
    this->Report["stock"] = this->Options.Stock;
    this->Report["look"] = scene.Look;
    if (!this->Options.Stock)
    {
      this->Report["accumulated-frames"] = pass->GetAccumulatedFrames(built.Renderer);
      const char* statistics = pass->GetStatistics();
      this->Report["pass"] = nlohmann::json::parse(statistics ? statistics : "", nullptr, false);
    }
  }

  RenderOptions Options;
  CLI::App* Declared = nullptr;
  nlohmann::ordered_json Report;
};
}

void AddRenderCommand(CLI::App& app, Console& console, int& status)
{
  AddCommand<RenderCommand>(app, console, status);
}
}
