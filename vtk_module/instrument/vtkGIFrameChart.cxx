// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIFrameChart.h"

#include "instrument/FrameChartLayout.h"
#include "instrument/FrameChartSvg.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkContextScene.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

using namespace penumbra;

struct vtkGIFrameChart::Internals
{
  FrameChartData Data;
  std::string Title;
  std::string LastError;
};

namespace
{
void UseFont(vtkContext2D* painter, double size)
{
  vtkTextProperty* font = painter->GetTextProp();
  font->SetFontFamilyToArial();
  font->SetFontSize(static_cast<int>(std::lround(size)));
  font->SetBold(false);
  font->SetItalic(false);
  font->SetShadow(false);
  font->SetOrientation(0.0);
  font->SetJustificationToLeft();
  font->SetVerticalJustificationToBottom();
}

/// Whether two rectangles can be drawn at once.
bool Joins(const ChartShape& a, const ChartShape& b)
{
  return a.Kind == ChartKind::Rectangle && b.Kind == ChartKind::Rectangle && a.Color.Alpha == 1.0 &&
    a.Color.Red == b.Color.Red && a.Color.Green == b.Color.Green && a.Color.Blue == b.Color.Blue;
}

/// Draws rectangles of one colour as one strip, whose parts between them have no area. Each call costs as much as many
/// rectangles, and the chart must not cost what it measures.
void PaintRectangles(vtkContext2D* painter, const ChartShape* first, const ChartShape* last,
  double left, double bottom)
{
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  const ChartColor& color = first->Color;
  painter->GetBrush()->SetColorF(color.Red, color.Green, color.Blue, color.Alpha);
  std::vector<float> points;
  const auto add = [&](double x, double y) {
    points.push_back(static_cast<float>(left + x));
    points.push_back(static_cast<float>(bottom + y));
  };
  for (const ChartShape* shape = first; shape != last; ++shape)
  {
    const ChartBox& box = shape->Box;
    add(box.Left, box.Bottom);
    add(box.Left, box.Bottom);
    add(box.Left, box.Bottom);
    add(box.Left, box.Top);
    add(box.Right, box.Bottom);
    add(box.Right, box.Top);
    add(box.Right, box.Bottom);
    add(box.Right, box.Bottom);
  }
  painter->DrawQuadStrip(points.data(), static_cast<int>(points.size() / 2));
}

void PaintShape(vtkContext2D* painter, const ChartShape& shape, double left, double bottom)
{
  const ChartBox& box = shape.Box;
  const ChartColor& color = shape.Color;
  const auto x = static_cast<float>(left + box.Left);
  const auto y = static_cast<float>(bottom + box.Bottom);
  vtkPen* pen = painter->GetPen();
  const bool line = shape.Kind == ChartKind::Line;
  pen->SetLineType(line ? vtkPen::SOLID_LINE : vtkPen::NO_PEN);
  pen->SetColorF(color.Red, color.Green, color.Blue, color.Alpha);
  painter->GetBrush()->SetColorF(color.Red, color.Green, color.Blue, color.Alpha);
  switch (shape.Kind)
  {
    case ChartKind::Rectangle:
      painter->DrawRect(x, y, static_cast<float>(box.Width()), static_cast<float>(box.Height()));
      break;
    case ChartKind::Line:
      pen->SetWidth(static_cast<float>(shape.Size));
      painter->DrawLine(
        x, y, static_cast<float>(left + box.Right), static_cast<float>(bottom + box.Top));
      break;
    case ChartKind::Disc:
    {
      const auto radius = static_cast<float>(0.5 * box.Width());
      painter->DrawEllipse(x + radius, y + radius, radius, radius);
      break;
    }
    case ChartKind::Text:
      UseFont(painter, shape.Size);
      painter->GetTextProp()->SetColor(color.Red, color.Green, color.Blue);
      painter->GetTextProp()->SetOpacity(color.Alpha);
      painter->DrawString(x, y, shape.Text.c_str());
      break;
  }
}
}

vtkStandardNewMacro(vtkGIFrameChart);

vtkGIFrameChart::vtkGIFrameChart()
  : Impl(std::make_unique<Internals>())
{
}

vtkGIFrameChart::~vtkGIFrameChart() = default;

bool vtkGIFrameChart::SetStatistics(const char* json)
{
  const bool read = ReadFrameChart(json, this->Impl->Data, this->Impl->LastError);
  if (read)
  {
    this->Modified();
  }
  return read;
}

const char* vtkGIFrameChart::GetLastError()
{
  return this->Impl->LastError.c_str();
}

bool vtkGIFrameChart::WriteSVG(const char* path, int width, int height)
{
  constexpr int most = 16384;
  if (width < 1 || height < 1 || width > most || height > most)
  {
    this->Impl->LastError = "A chart of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels cannot be written: give sizes from 1 to " + std::to_string(most) + ".";
    return false;
  }
  ChartStyle style;
  style.Width = width;
  style.Height = height;
  style.Title = this->Impl->Title;
  std::ofstream file(path ? path : "", std::ios::binary);
  file << FrameChartSvg(LayOutFrameChart(this->Impl->Data, style), width, height);
  file.close();
  this->Impl->LastError = file ? ""
                               : std::string("The chart cannot be written to \"") +
      (path ? path : "") + "\": check the folder and its permissions.";
  return static_cast<bool>(file);
}

void vtkGIFrameChart::SetTitle(const char* title)
{
  const std::string text = title ? title : "";
  if (text != this->Impl->Title)
  {
    this->Impl->Title = text;
    this->Modified();
  }
}

const char* vtkGIFrameChart::GetTitle()
{
  return this->Impl->Title.c_str();
}

bool vtkGIFrameChart::Paint(vtkContext2D* painter)
{
  vtkContextScene* scene = this->GetScene();
  if (!painter || !scene)
  {
    return false;
  }
  const int width = scene->GetSceneWidth() > 0 ? scene->GetSceneWidth() : scene->GetViewWidth();
  const int height = scene->GetSceneHeight() > 0 ? scene->GetSceneHeight() : scene->GetViewHeight();
  ChartStyle style;
  style.Width = std::min(this->Area[2] > 0 ? this->Area[2] : width, width - this->Area[0]);
  style.Height = std::min(this->Area[3] > 0 ? this->Area[3] : height, height - this->Area[1]);
  if (style.Width <= 0 || style.Height <= 0)
  {
    return true; // a window that is too small shows no chart
  }
  style.Panel = this->Panel;
  style.Title = this->Impl->Title;
  style.Measure = [painter](const std::string& text, double size) {
    UseFont(painter, size);
    float bounds[4] = { 0.0F, 0.0F, 0.0F, 0.0F }; // the corner, then the size
    painter->ComputeStringBounds(text.c_str(), bounds);
    return static_cast<double>(bounds[2]);
  };
  const std::vector<ChartShape> shapes = LayOutFrameChart(this->Impl->Data, style);
  for (std::size_t i = 0; i < shapes.size();)
  {
    std::size_t end = i + 1;
    while (end < shapes.size() && Joins(shapes[i], shapes[end]))
    {
      ++end;
    }
    if (end - i > 1)
    {
      PaintRectangles(painter, &shapes[i], &shapes[i] + (end - i), this->Area[0], this->Area[1]);
    }
    else
    {
      PaintShape(painter, shapes[i], this->Area[0], this->Area[1]);
    }
    i = end;
  }
  return true;
}

void vtkGIFrameChart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Title: " << this->Impl->Title << "\n"
     << indent << "Panel: " << (this->Panel ? "on" : "off") << "\n"
     << indent << "Area: " << this->Area[0] << ", " << this->Area[1] << ", " << this->Area[2]
     << ", " << this->Area[3] << "\n"
     << indent << "Passes: " << this->Impl->Data.Passes.size() << "\n";
}
