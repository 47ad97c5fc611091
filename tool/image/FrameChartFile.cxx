// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/FrameChartFile.h"

#include "common/Failure.h"
#include "common/Windows.h"
#include "image/Capture.h"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkGIFrameChart.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <filesystem>

namespace penumbra::tool
{
namespace
{
Picture DrawChart(vtkGIFrameChart* chart, int width, int height, const std::string& backend)
{
  vtkSmartPointer<vtkRenderWindow> window = MakeWindow(backend);
  window->SetMultiSamples(8); // smooth lines and fractions of pixels
  window->SetSize(width, height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  chart->SetPanel(false);
  actor->GetScene()->AddItem(chart);
  renderer->AddActor(actor);
  OpenWindow(window);
  window->Render();
  return CaptureWindow(window, false);
}
}

void RequireChartName(const std::string& path)
{
  const std::filesystem::path name(path);
  if (name.extension() != ".svg" && name.extension() != ".png")
  {
    FailUsage("'{}' is not a valid name for a chart: it must end with .svg or .png", path);
  }
  if (name.has_parent_path() && !std::filesystem::is_directory(name.parent_path()))
  {
    Fail("there is no folder '{}' for the chart", name.parent_path().string());
  }
}

void WriteFrameChart(
  const std::string& path, const char* json, int width, int height, const std::string& backend)
{
  RequireChartName(path);
  vtkNew<vtkGIFrameChart> chart;
  const bool isPicture = std::filesystem::path(path).extension() == ".png";
  if (!chart->SetStatistics(json) || (!isPicture && !chart->WriteSVG(path.c_str(), width, height)))
  {
    Fail("{}", chart->GetLastError());
  }
  if (isPicture)
  {
    WritePicture(path, DrawChart(chart, width, height, backend));
  }
}
}
