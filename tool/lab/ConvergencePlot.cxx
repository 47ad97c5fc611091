// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/ConvergencePlot.h"

#include "common/Windows.h"
#include "image/Capture.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
constexpr int Width = 640;
constexpr int Height = 400;
constexpr int FontSize = 13;
constexpr std::array<std::array<unsigned char, 3>, 4> Colors = { { { 38, 96, 176 }, { 196, 60, 52 },
  { 86, 168, 96 }, { 120, 90, 160 } } };

vtkAxis* SetAxis(vtkChartXY* chart, int which, const std::string& title, double low, double high)
{
  vtkAxis* axis = chart->GetAxis(which);
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(low, high);
  axis->GetTitleProperties()->SetFontSize(FontSize);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(FontSize - 1);
  return axis;
}

/// The axis holds logarithms: labels give the powers of ten themselves.
void LabelDecades(vtkAxis* axis, double low, double high)
{
  vtkNew<vtkDoubleArray> decades;
  vtkNew<vtkStringArray> names;
  for (double decade = low; decade <= high; ++decade)
  {
    decades->InsertNextValue(decade);
    names->InsertNextValue(fmt::format("{:g}", std::pow(10.0, decade)));
  }
  axis->SetCustomTickPositions(decades, names);
}

void AddLine(vtkChartXY* chart, const ConvergenceCurve& curve, std::size_t index)
{
  vtkNew<vtkDoubleArray> work;
  work->SetName("work");
  vtkNew<vtkDoubleArray> residual;
  residual->SetName("residual");
  for (const auto& step : curve.Steps)
  {
    work->InsertNextValue(step[0]);
    residual->InsertNextValue(std::log10(std::max(step[1], 1e-300)));
  }
  vtkNew<vtkTable> table;
  table->AddColumn(work);
  table->AddColumn(residual);
  vtkNew<vtkPlotLine> line;
  line->SetInputData(table, 0, 1);
  const auto& color = Colors[index % Colors.size()];
  line->SetColor(color[0], color[1], color[2], 255);
  line->SetWidth(2.5f);
  line->SetLabel(curve.Name);
  chart->AddPlot(line);
}
}

Picture DrawConvergence(const std::vector<ConvergenceCurve>& curves, const std::string& workTitle,
  const std::string& backend)
{
  double most = 1.0;
  double least = 0.1;
  for (const ConvergenceCurve& curve : curves)
  {
    for (const auto& step : curve.Steps)
    {
      most = std::max(most, step[0]);
      least = step[1] > 0.0 ? std::min(least, step[1]) : least;
    }
  }
  const auto window = MakeWindow(backend);
  vtkNew<vtkContextView> view;
  view->SetRenderWindow(window);
  window->SetSize(Width, Height);
  window->SetMultiSamples(8);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  OpenWindow(window);
  vtkNew<vtkChartXY> chart;
  const double low = std::floor(std::log10(least));
  SetAxis(chart, vtkAxis::BOTTOM, workTitle, 0.0, most);
  LabelDecades(
    SetAxis(chart, vtkAxis::LEFT, "residual, of the power first reflected", low, 0.0), low, 0.0);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    AddLine(chart, curves[i], i);
  }
  chart->SetShowLegend(true);
  view->GetScene()->AddItem(chart);
  window->Render();
  Picture picture = CaptureWindow(window, false);
  window->Finalize();
  return picture;
}
}
