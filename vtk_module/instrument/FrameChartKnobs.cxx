// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instrument/FrameChartLabels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace penumbra
{
namespace
{
/// Axes of the plot: linear in milliseconds, logarithmic in the error, with a row for 0 at the bottom.
struct Scales
{
  ChartBox Plot;
  double Range = 0.0;   ///< milliseconds at the right
  double Lowest = 0.0;  ///< logarithm (base 10) of the error above the bottom row
  double Highest = 0.0; ///< at the top
  double Step = 0.0;    ///< the height of the bottom row in pixels

  double X(double milliseconds) const
  {
    return this->Plot.Left + Drawable(milliseconds) / this->Range * this->Plot.Width();
  }
  double Y(double error) const
  {
    if (Drawable(error) <= 0.0)
    {
      return this->Plot.Bottom;
    }
    const double power = std::max(std::log10(Drawable(error)), this->Lowest);
    return this->Plot.Bottom + this->Step +
      (power - this->Lowest) / (this->Highest - this->Lowest) * (this->Plot.Height() - this->Step);
  }
};

Scales FindScales(const FrameChartData& data, const ChartBox& plot, double line)
{
  // Errors that are smaller by more powers of ten are as good as exact; they are drawn at the lowest of these.
  constexpr int mostPowers = 5;
  Scales scales;
  scales.Plot = plot;
  scales.Step = std::min(1.2 * line, 0.3 * plot.Height());
  double least = 1e300;
  double largest = 0.0;
  for (const ChartKnob& knob : data.Knobs)
  {
    for (const ChartLevel& level : knob.Levels)
    {
      scales.Range = std::max(scales.Range, Drawable(level.Milliseconds));
      const double error = Drawable(level.Error);
      largest = std::max(largest, error);
      least = error > 0.0 ? std::min(least, error) : least;
    }
  }
  scales.Range = scales.Range > 0.0 ? 1.08 * scales.Range : 1.0;
  // A range of a power of ten at least, with a little space around the points.
  const double high = largest > 0.0 ? std::log10(largest) : 0.0;
  const double low = largest > 0.0 ? std::max(std::log10(least), high - mostPowers) : 0.0;
  const double space = std::max(0.12, 0.5 * (1.0 - (high - low)));
  scales.Lowest = low - space;
  scales.Highest = high + space;
  return scales;
}

void DrawAxes(ChartSheet& sheet, const Scales& scales)
{
  const ChartBox& plot = scales.Plot;
  const double line = sheet.LineHeight();
  const double size = sheet.FontSize();
  const ChartColor faint = sheet.Faint();
  ChartColor grid = faint;
  grid.Alpha = 0.25;
  sheet.Line(ChartRole::Axis, plot.Left, plot.Bottom, plot.Right, plot.Bottom, faint);
  sheet.Text("exact", plot.Left - 0.4 * size, plot.Bottom - 0.5 * line, faint, 1.0);
  // Powers of ten, and twice and five times these in a short range.
  const bool more = scales.Highest - scales.Lowest < 1.7;
  for (int power = static_cast<int>(std::floor(scales.Lowest)); power <= scales.Highest; ++power)
  {
    for (const int factor : { 1, 2, 5 })
    {
      const double error = factor * std::pow(10.0, power);
      const double y = scales.Y(error);
      const bool inside = std::log10(error) >= scales.Lowest && std::log10(error) <= scales.Highest;
      if (inside && (factor == 1 || more))
      {
        char text[32];
        std::snprintf(text, sizeof(text), "%.6g", error);
        sheet.Line(ChartRole::Axis, plot.Left, y, plot.Right, y, grid);
        sheet.Text(text, plot.Left - 0.4 * size, y - 0.5 * line, faint, 1.0);
      }
    }
  }
  const double widest = sheet.TextWidth(FormatMilliseconds(scales.Range)) + 2.0 * size;
  const double step =
    TickStep(scales.Range, std::clamp(static_cast<int>(plot.Width() / widest), 2, 8));
  for (int i = 0; i * step <= scales.Range; ++i)
  {
    const double x = scales.X(i * step);
    char text[32];
    std::snprintf(text, sizeof(text), "%.6g", i * step);
    sheet.Line(ChartRole::Axis, x, plot.Bottom, x, plot.Bottom - 3.0, faint);
    sheet.Text(i == 0 ? "0 ms" : text, x, plot.Bottom - 3.0 - line, faint, i == 0 ? 0.0 : 0.5);
  }
}

void DrawKnob(ChartSheet& sheet, const ChartKnob& knob, const Scales& scales)
{
  const ChartColor color = sheet.Color(knob.Payment);
  const double radius = 0.22 * sheet.FontSize();
  for (std::size_t i = 0; i + 1 < knob.Levels.size(); ++i)
  {
    const ChartLevel& a = knob.Levels[i];
    const ChartLevel& b = knob.Levels[i + 1];
    sheet.Line(ChartRole::Level, scales.X(a.Milliseconds), scales.Y(a.Error),
      scales.X(b.Milliseconds), scales.Y(b.Error), color, 1.5);
  }
  for (const ChartLevel& level : knob.Levels)
  {
    const double x = scales.X(level.Milliseconds);
    const double y = scales.Y(level.Error);
    const std::string description =
      knob.Technique + " " + level.Name + ": " + FormatMilliseconds(level.Milliseconds) + " ms";
    sheet.Disc(ChartRole::Level, x, y, radius + 1.0, color, description);
    sheet.Disc(ChartRole::Level, x, y, radius - 0.5, sheet.Paper(), description);
    sheet.Reserve({ x - radius, y - radius, x + radius, y + radius });
  }
}

/// The knobs' lines, as boxes from one end to the other.
std::vector<ChartBox> FindLines(const FrameChartData& data, const Scales& scales)
{
  std::vector<ChartBox> lines;
  for (const ChartKnob& knob : data.Knobs)
  {
    for (std::size_t i = 0; i + 1 < knob.Levels.size(); ++i)
    {
      const ChartLevel& a = knob.Levels[i];
      const ChartLevel& b = knob.Levels[i + 1];
      lines.push_back({ scales.X(a.Milliseconds), scales.Y(a.Error), scales.X(b.Milliseconds),
        scales.Y(b.Error) });
    }
  }
  return lines;
}

std::vector<ChartPoint> FindPoints(const FrameChartData& data, const Scales& scales)
{
  std::vector<ChartPoint> points;
  for (const ChartKnob& knob : data.Knobs)
  {
    if (knob.Level >= 0 && knob.Level < static_cast<int>(knob.Levels.size()))
    {
      const ChartLevel& level = knob.Levels[knob.Level];
      std::string name = knob.Technique;
      std::replace(name.begin(), name.end(), '_', ' ');
      points.push_back(
        { name, level.Name, knob.Payment, scales.X(level.Milliseconds), scales.Y(level.Error) });
    }
  }
  return points;
}
}

void LayOutKnobs(ChartSheet& sheet, const FrameChartData& data, const ChartBox& box)
{
  const double line = sheet.LineHeight();
  const double size = sheet.FontSize();
  const double margin = sheet.TextWidth("0.0001") + 0.5 * size; // holds the labels of the axis
  const ChartBox plot{ box.Left + margin, std::round(box.Bottom + 1.1 * line), box.Right,
    box.Top - 1.6 * line };
  const bool any = std::any_of(data.Knobs.begin(), data.Knobs.end(),
    [](const ChartKnob& knob) { return !knob.Levels.empty(); });
  if (!any || plot.Height() < 2.0 * line || plot.Width() < 2.0 * margin)
  {
    return;
  }
  sheet.Text("Error over cost of each knob", box.Left, box.Top - line, sheet.Ink());
  const Scales scales = FindScales(data, plot, line);
  DrawAxes(sheet, scales);
  for (const ChartKnob& knob : data.Knobs)
  {
    DrawKnob(sheet, knob, scales);
  }
  // Above all lines and below all labels.
  const double radius = 0.42 * size;
  const std::vector<ChartPoint> points = FindPoints(data, scales);
  for (const ChartPoint& point : points)
  {
    sheet.Disc(ChartRole::Axis, point.X, point.Y, radius + 1.5, sheet.Paper());
    sheet.Disc(ChartRole::Force, point.X, point.Y, radius, sheet.Color(point.Payment),
      point.Name + " " + point.Level);
    sheet.Reserve({ point.X - radius, point.Y - radius, point.X + radius, point.Y + radius });
  }
  LabelInBestOrder(sheet, points, radius, plot, FindLines(data, scales));
}
}
