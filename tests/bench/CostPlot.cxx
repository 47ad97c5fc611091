// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CostPlot.h"

#include "vtkHeadlessRenderWindow.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlot.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace bench
{
namespace
{
void AddColumn(vtkTable* table, const char* name, const std::vector<CostPoint>& points,
  const std::function<double(const CostPoint&)>& value)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  for (const CostPoint& point : points)
  {
    array->InsertNextValue(static_cast<float>(value(point)));
  }
  table->AddColumn(array);
}

void SetAxis(vtkChart* chart, int position, const char* title, double low, double high)
{
  vtkAxis* axis = chart->GetAxis(position);
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(low, high);
}

void Draw(vtkChart* chart, const std::string& file)
{
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkRenderer> renderer;
  actor->GetScene()->AddItem(chart);
  actor->GetScene()->SetRenderer(renderer);
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(640, 400);
  window->SetMultiSamples(4);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error(file + " cannot be written.");
  }
}
}

void PlotCost(const std::vector<CostPoint>& points, const std::string& file)
{
  const auto exponent = [](const CostPoint& point) { return std::log10(point.Triangles); };
  const auto milliseconds = [](const CostPoint& point) { return point.Milliseconds; };
  vtkNew<vtkTable> table;
  AddColumn(table, "triangles", points, exponent);
  AddColumn(table, "milliseconds", points, milliseconds);
  double maximum = 0.0;
  for (const CostPoint& point : points)
  {
    maximum = std::max(maximum, point.Milliseconds);
  }
  vtkNew<vtkChartXY> chart;
  auto* line = vtkPlotPoints::SafeDownCast(chart->AddPlot(vtkChart::LINE));
  line->SetInputData(table, 0, 1);
  line->SetColor(30, 90, 180, 255);
  line->SetWidth(2.5F);
  line->SetMarkerStyle(vtkPlotPoints::CIRCLE);
  SetAxis(chart, vtkAxis::BOTTOM, "logarithm of triangles, base 10", exponent(points.front()),
    exponent(points.back()) + 0.05);
  SetAxis(chart, vtkAxis::LEFT, "milliseconds of an update", 0.0, 1.15 * maximum);
  Draw(chart, file);
}
}
