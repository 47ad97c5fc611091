// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/FrameChartFile.h"

#include "common/Failure.h"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkErrorCode.h>
#include <vtkGIFrameChart.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <filesystem>
#include <fstream>

namespace penumbra::tool
{
namespace
{
bool WriteSvg(const std::string& path, const char* json, int width, int height, std::string& error)
{
  vtkNew<vtkGIFrameChart> chart;
  const bool done = chart->SetStatistics(json) && chart->WriteSVG(path.c_str(), width, height);
  error = chart->GetLastError();
  return done;
}

bool WritePng(const std::string& path, const char* json, int width, int height, std::string& error)
{
  vtkNew<vtkGIFrameChart> chart;
  chart->SetPanel(false);
  if (!chart->SetStatistics(json))
  {
    error = chart->GetLastError();
    return false;
  }
  // VTK reports an error for a file that it cannot open.
  if (!std::ofstream(path, std::ios::binary))
  {
    error =
      "The chart cannot be written to \"" + path + "\": check the folder and its permissions.";
    return false;
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8); // smooth lines and fractions of pixels
  window->SetSize(width, height);
  if (!window->SupportsOpenGL())
  {
    error = "A chart as .png needs OpenGL, and no context can be created: write it as .svg.";
    return false;
  }
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  renderer->AddActor(actor);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    error = "The chart cannot be written to \"" + path + "\": check the space on the disk.";
    return false;
  }
  return true;
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

bool WriteFrameChart(
  const std::string& path, const char* json, int width, int height, std::string& error)
{
  constexpr int most = 16384; // what OpenGL draws at once
  if (width < 1 || height < 1 || width > most || height > most)
  {
    error = "A chart of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels cannot be written: give sizes from 1 to " + std::to_string(most) + ".";
    return false;
  }
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".svg")
  {
    return WriteSvg(path, json, width, height, error);
  }
  if (extension == ".png")
  {
    return WritePng(path, json, width, height, error);
  }
  error =
    "The chart cannot be written to \"" + path + "\": give a name that ends with .svg or .png.";
  return false;
}
}
