// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PassCost.h"

#include "Cost.h"
#include "FrameScenes.h"

#include "vtkGIPass.h"
#include "vtkGITechnique.h"
#include "vtkHeadlessRenderWindow.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>

namespace bench
{
namespace
{
constexpr int WarmFrames = 30; // shaders compile, probes settle

vtkGIPass* AddPass(vtkRenderer* renderer, const PassCostOptions& options)
{
  vtkNew<vtkGIPass> pass;
  if (!pass->SetPreset(options.Preset.c_str()))
  {
    throw std::runtime_error("there is no preset " + options.Preset + ".");
  }
  for (const auto& entry : options.Techniques)
  {
    const bool on = entry.empty() || entry[0] != '-';
    vtkGITechnique* technique = pass->GetTechnique(entry.c_str() + (on ? 0 : 1));
    if (!technique)
    {
      throw std::runtime_error("there is no technique " + entry + ".");
    }
    technique->SetEnabled(on);
  }
  pass->CollectStatisticsOn();
  renderer->SetPass(pass);
  return pass;
}

// Milliseconds by pass. A pass that runs several times in a frame is summed.
struct Times
{
  std::vector<std::string> Order;
  std::map<std::string, std::vector<double>> Frames;
  std::map<std::string, int> Runs; // in the last frame

  void Add(const nlohmann::json& statistics)
  {
    this->Runs.clear();
    std::map<std::string, double> sums;
    for (const auto& row : statistics.at("passes"))
    {
      const std::string name = row.at("name");
      sums[name] += row.at("milliseconds").get<double>();
      ++this->Runs[name];
    }
    for (const auto& [name, sum] : sums)
    {
      this->AddTo(name, sum);
    }
    this->AddTo("", statistics.at("milliseconds"));
  }
  void AddTo(const std::string& name, double milliseconds)
  {
    if (this->Frames.find(name) == this->Frames.end())
    {
      this->Order.push_back(name);
    }
    this->Frames[name].push_back(milliseconds);
  }
  double Median(const std::string& name) const
  {
    return penumbra_test::MedianOf(this->Frames.at(name));
  }
};
}

void ReportPassCost(
  const PassCostOptions& options, vtkPolyData& surface, int width, int height, int frames)
{
  vtkGIPass* pass = nullptr;
  Stage stage({ options.Preset,
                [&](vtkRenderer* renderer) { pass = AddPass(renderer, options); },
                [](vtkActor*) {} },
    &surface, width, height);
  const auto draw = [&] { return options.Still ? stage.RepeatFrame() : stage.DrawFrame(); };
  for (int i = 0; i < WarmFrames; ++i)
  {
    draw();
  }
  Times times;
  std::vector<double> whole;
  for (int i = 0; i < frames; ++i)
  {
    whole.push_back(1e3 * draw());
    times.Add(nlohmann::json::parse(pass->GetStatistics()));
  }
  std::sort(times.Order.begin(), times.Order.end(),
    [&times](const auto& a, const auto& b) { return times.Median(a) > times.Median(b); });
  std::printf("%s, %d triangles, %d x %d, median of %d frames%s\n\n%-32s %6s %10s %7s\n",
    options.Preset.c_str(), static_cast<int>(surface.GetNumberOfPolys()), width, height, frames,
    options.Still ? " of a still camera" : "", "pass", "runs", "ms", "share");
  for (const auto& name : times.Order)
  {
    if (!name.empty())
    {
      std::printf("%-32s %6d %10.3f %6.1f%%\n", name.c_str(), times.Runs[name], times.Median(name),
        100.0 * times.Median(name) / std::max(times.Median(""), 1e-9));
    }
  }
  std::printf("%-32s %6s %10.3f\n", "all passes", "", times.Median(""));
  std::printf("%-32s %6s %10.3f\n", "frame by the clock", "", penumbra_test::MedianOf(whole));
}
}
