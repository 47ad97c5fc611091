// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/BiasPlot.h"

#include "common/Failure.h"
#include "common/Windows.h"
#include "image/Capture.h"
#include "lab/BiasReport.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotArea.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkSVGExporter.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace penumbra::tool
{
namespace
{
constexpr int ChartWidth = 520;
constexpr int ChartHeight = 360;
constexpr int Space = 8; // around a chart
constexpr int FontSize = 13;

// Acne spans decades: the axis holds the logarithm of its percentage, and less than this is none.
constexpr double LeastPercent = 1e-4;
constexpr double MostPercent = 100;

// Gaps wider than so many times what is still good are drawn as if they were that wide.
constexpr double MostLimits = 6;

using Rgb = std::array<unsigned char, 3>;
constexpr Rgb AcneColor = { 196, 60, 52 };
constexpr Rgb GapColor = { 38, 96, 176 };
constexpr Rgb SafeColor = { 86, 168, 96 };

double LogPercent(double share)
{
  return std::log10(std::clamp(100 * share, LeastPercent, MostPercent));
}

/// Columns of numbers under their names.
vtkSmartPointer<vtkTable> Columns(
  const std::vector<std::pair<std::string, std::vector<double>>>& columns)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const auto& [name, values] : columns)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (const double value : values)
    {
      column->InsertNextValue(value);
    }
    table->AddColumn(column);
  }
  return table;
}

class Chart
{
public:
  Chart(const BiasSweep& sweep, const BiasLimits& limits, double mostGap)
    : Low(sweep.Samples.front().Bias)
    , High(sweep.Samples.back().Bias)
  {
    this->MostGap = mostGap;
    this->SetUp(sweep, limits);
    if (const auto window = sweep.Window(limits))
    {
      this->AddSafeWindow(*window);
    }
    std::vector<double> biases, acne, gap;
    for (const BiasSample& sample : sweep.Samples)
    {
      biases.push_back(sample.Bias);
      acne.push_back(LogPercent(sample.Errors.Acne));
      gap.push_back(std::min(sample.Errors.Gap(), mostGap));
    }
    this->AddLine("acne", biases, acne, AcneColor, vtkPen::SOLID_LINE, 2.5f, false);
    this->AddLine("gap", biases, gap, GapColor, vtkPen::SOLID_LINE, 2.5f, true);
    const std::vector<double> ends = { this->Low, this->High };
    const double worst = LogPercent(limits.Acne);
    this->AddLine("acne limit", ends, { worst, worst }, AcneColor, vtkPen::DASH_LINE, 1, false);
    this->AddLine(
      "gap limit", ends, { limits.Gap, limits.Gap }, GapColor, vtkPen::DASH_LINE, 1, true);
  }

  vtkChartXY* Get() { return this->Drawn; }

private:
  void SetUp(const BiasSweep& sweep, const BiasLimits& limits)
  {
    // The empty line keeps the title off the highest label.
    this->Drawn->SetTitle(
      fmt::format("{} bias: {}\n ", sweep.Kind, SummarizeWindow(sweep, limits)));
    this->Drawn->GetTitleProperties()->SetFontSize(FontSize + 1);
    this->Drawn->SetAutoSize(false);
    this->SetAxis(vtkAxis::BOTTOM, "bias, texels of the map", this->Low, this->High, { 0, 0, 0 });
    vtkAxis* acne = this->SetAxis(vtkAxis::LEFT, "acne, % of the light on lit surfaces",
      std::log10(LeastPercent), std::log10(MostPercent), AcneColor);
    vtkNew<vtkDoubleArray> decades;
    vtkNew<vtkStringArray> names;
    for (double decade = std::log10(LeastPercent); decade <= std::log10(MostPercent); ++decade)
    {
      decades->InsertNextValue(decade);
      names->InsertNextValue(
        decade == std::log10(LeastPercent) ? "none" : fmt::format("{:g}", std::pow(10, decade)));
    }
    acne->SetCustomTickPositions(decades, names);
    const bool cut = std::any_of(sweep.Samples.begin(), sweep.Samples.end(),
      [this](const BiasSample& sample) { return sample.Errors.Gap() > this->MostGap; });
    const std::string gap = cut ? "gap, texels" : "gap, texels of the map";
    const std::string top = cut ? fmt::format("; {:g} or more at the top", this->MostGap) : "";
    this->SetAxis(vtkAxis::RIGHT, (gap + top).c_str(), 0, this->MostGap, GapColor)
      ->SetVisible(true);
  }

  vtkAxis* SetAxis(int which, const char* title, double low, double high, const Rgb& color)
  {
    vtkAxis* axis = this->Drawn->GetAxis(which);
    axis->SetTitle(title);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(low, high);
    axis->GetTitleProperties()->SetFontSize(FontSize);
    axis->GetTitleProperties()->BoldOff();
    for (vtkTextProperty* text : { axis->GetTitleProperties(), axis->GetLabelProperties() })
    {
      text->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
    }
    axis->GetLabelProperties()->SetFontSize(FontSize - 1);
    axis->SetGridVisible(which != vtkAxis::RIGHT);
    return axis;
  }

  void AddSafeWindow(const BiasWindow& window)
  {
    const double low = std::log10(LeastPercent), high = std::log10(MostPercent);
    // A window of one sample is shown too.
    const double half = window.High > window.Low ? 0 : 0.004 * (this->High - this->Low);
    // VTK 9.2 draws nothing of an area of fewer than four points.
    const std::vector<double> biases = EvenSteps(window.Low - half, window.High + half, 4);
    vtkNew<vtkPlotArea> area;
    area->SetInputData(
      Columns({ { "bias", biases }, { "low", std::vector<double>(biases.size(), low) },
        { "high", std::vector<double>(biases.size(), high) } }));
    area->SetInputArray(0, "bias");
    area->SetInputArray(1, "low");
    area->SetInputArray(2, "high");
    area->GetBrush()->SetColor(SafeColor[0], SafeColor[1], SafeColor[2], 60);
    area->GetPen()->SetLineType(vtkPen::NO_PEN);
    area->SetLabel("safe");
    this->Drawn->AddPlot(area);
    this->AddLine("take", { window.Choice, window.Choice }, { low, high }, SafeColor,
      vtkPen::SOLID_LINE, 2, false);
  }

  void AddLine(const char* name, const std::vector<double>& x, const std::vector<double>& y,
    const Rgb& color, int style, float width, bool right)
  {
    vtkNew<vtkPlotLine> line;
    line->SetInputData(Columns({ { "x", x }, { name, y } }), 0, 1);
    line->SetColor(color[0], color[1], color[2], 255);
    line->SetWidth(width);
    line->GetPen()->SetLineType(style);
    line->SetLabel(name);
    this->Drawn->AddPlot(line);
    this->Drawn->SetPlotCorner(line, right ? 1 : 0);
  }

  vtkNew<vtkChartXY> Drawn;
  double Low;
  double High;
  double MostGap = 1;
};

/// Of all charts, so that they can be compared.
double MostGap(const BiasStudy& study)
{
  double most = 2 * study.Options.Limits.Gap;
  for (const BiasSweep& sweep : study.Sweeps)
  {
    for (const BiasSample& sample : sweep.Samples)
    {
      most = std::max(most, sample.Errors.Gap());
    }
  }
  return std::min(std::ceil(most), MostLimits * study.Options.Limits.Gap);
}

void WriteSvg(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName(file.c_str());
  exporter->SetTitle("Shadow maps: acne and gap over the bias");
  exporter->Write();
  std::error_code error;
  if (std::filesystem::file_size(file, error) == 0 || error)
  {
    Fail("'{}' cannot be written: make room on the disk, or choose another folder with -o", file);
  }
}
}

Picture DrawBiasPlot(const BiasStudy& study, const std::string& backend, const std::string& svgFile)
{
  const auto window = MakeWindow(backend);
  vtkNew<vtkContextView> view;
  view->SetRenderWindow(window);
  const int count = static_cast<int>(study.Sweeps.size());
  window->SetSize(ChartWidth * count, ChartHeight);
  window->SetMultiSamples(8);
  view->GetRenderer()->SetBackground(1, 1, 1);
  OpenWindow(window);
  const double mostGap = MostGap(study);
  for (int i = 0; i < count; ++i)
  {
    Chart chart(study.Sweeps[i], study.Options.Limits, mostGap);
    chart.Get()->SetSize(vtkRectf(static_cast<float>(ChartWidth * i + Space), Space,
      ChartWidth - 2 * Space, ChartHeight - 2 * Space));
    view->GetScene()->AddItem(chart.Get());
  }
  window->Render();
  Picture picture = CaptureWindow(window, false);
  if (!svgFile.empty())
  {
    WriteSvg(window, svgFile);
  }
  window->Finalize();
  return picture;
}
}
