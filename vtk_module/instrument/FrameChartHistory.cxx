// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instrument/FrameChartSheet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace penumbra
{
namespace
{
constexpr int MostFrames = 120;

double Sum(const std::array<double, ApproachCount>& moment)
{
  double sum = 0.0;
  for (const double milliseconds : moment)
  {
    sum += Drawable(milliseconds);
  }
  return sum;
}

/// Milliseconds at the top. One slow frame must not flatten all others: what exceeds twice the budget leaves the plot.
double FindRange(const FrameChartData& data, int first)
{
  double longest = 0.0;
  for (std::size_t i = first; i < data.History.size(); ++i)
  {
    longest = std::max(longest, Sum(data.History[i]));
  }
  const double budget = Drawable(data.Budget);
  return budget > 0.0 ? std::clamp(1.05 * longest, 1.25 * budget, 2.0 * budget) : 1.05 * longest;
}

/// Frames side by side.
struct Columns
{
  const FrameChartData& Data;
  ChartBox Plot;
  double Scale = 1.0; ///< pixels per millisecond
  double Pitch = 1.0; ///< pixels from one column to the next
  double Gap = 0.0;
  int First = 0; ///< frame
  int Count = 0;

  double Left(int i) const { return this->Plot.Right - (this->Count - i) * this->Pitch; }
  const std::array<double, ApproachCount>& Moment(int i) const
  {
    return this->Data.History[this->First + i];
  }
};

void DrawColumns(ChartSheet& sheet, const Columns& columns)
{
  std::vector<double> bottoms(columns.Count, columns.Plot.Bottom);
  // One approach after the other, so that a painter can draw all of a colour at once.
  for (int s = 0; s < ApproachCount; ++s)
  {
    const auto approach = static_cast<Approach>(s);
    for (int i = 0; i < columns.Count; ++i)
    {
      const double milliseconds = Drawable(columns.Moment(i)[s]);
      const double bottom = bottoms[i];
      const double top = std::min(columns.Plot.Top, bottom + milliseconds * columns.Scale);
      if (top > bottom)
      {
        const double left = columns.Left(i);
        const std::string description =
          std::string(ApproachName(approach)) + ": " + FormatMilliseconds(milliseconds) + " ms";
        sheet.Rectangle(ChartRole::Column,
          { left, bottom, left + columns.Pitch - columns.Gap, top }, sheet.Color(approach),
          milliseconds, description);
      }
      bottoms[i] = top;
    }
  }
}

/// A cap on each column over budget, taller if the column leaves the plot. Returns the number of caps.
int MarkLateFrames(ChartSheet& sheet, const Columns& columns, double budget)
{
  int count = 0;
  for (int i = 0; i < columns.Count; ++i)
  {
    const double sum = Sum(columns.Moment(i));
    if (budget > 0.0 && sum > budget)
    {
      const bool cut = sum * columns.Scale > columns.Plot.Height();
      const double bottom =
        columns.Plot.Bottom + std::min(sum * columns.Scale, columns.Plot.Height());
      const double left = columns.Left(i);
      sheet.Rectangle(ChartRole::Over,
        { left, bottom + 1.0, left + columns.Pitch - columns.Gap, bottom + (cut ? 6.0 : 3.0) },
        sheet.Alarm(), 0.0, FormatMilliseconds(sum) + " ms");
      ++count;
    }
  }
  return count;
}

void DrawAxis(ChartSheet& sheet, const ChartBox& plot, double range, double scale, double budget)
{
  const double line = sheet.LineHeight();
  const double away = plot.Left - 0.4 * sheet.FontSize();
  if (budget > 0.0)
  {
    const double y = plot.Bottom + budget * scale;
    sheet.Line(ChartRole::Budget, plot.Left, y, plot.Right, y, sheet.Paper(), 3.0);
    sheet.Line(ChartRole::Budget, plot.Left, y, plot.Right, y, sheet.Alarm(), 1.5);
    sheet.Text(FormatMilliseconds(budget), away, y - 0.5 * line, sheet.Alarm(), 1.0);
  }
  sheet.Line(ChartRole::Axis, plot.Left, plot.Bottom, plot.Right, plot.Bottom, sheet.Faint());
  const double step = TickStep(range, std::max(2, static_cast<int>(plot.Height() / (2.0 * line))));
  for (int i = 0; i * step <= range; ++i)
  {
    const double y = plot.Bottom + i * step * scale;
    char text[32];
    std::snprintf(text, sizeof(text), "%.6g", i * step);
    if (sheet.Text(i == 0 ? "0 ms" : text, away, y - 0.5 * line, sheet.Faint(), 1.0))
    {
      sheet.Line(ChartRole::Axis, plot.Left - 3.0, y, plot.Left, y, sheet.Faint());
    }
  }
}
}

void LayOutHistory(ChartSheet& sheet, const FrameChartData& data, const ChartBox& box)
{
  const double line = sheet.LineHeight();
  const double size = sheet.FontSize();
  const double budget = Drawable(data.Budget);
  // Holds the labels of the axis.
  const double margin =
    std::max(sheet.TextWidth(FormatMilliseconds(budget)), 3.0 * size) + 0.5 * size;
  // Whole pixels: columns of equal width look alike without antialiasing.
  ChartBox plot{ box.Left + margin, std::round(box.Bottom + 1.1 * line), std::floor(box.Right),
    box.Top - 1.6 * line };
  // A column takes a pixel at least.
  const int most = std::clamp(static_cast<int>(plot.Width()), 0, MostFrames);
  const int count = static_cast<int>(std::min<std::size_t>(data.History.size(), most));
  const int first = static_cast<int>(data.History.size()) - count;
  const double range = FindRange(data, first);
  if (count == 0 || range <= 0.0 || plot.Height() < 2.0 * line)
  {
    sheet.Text("No frames yet.", box.Left, box.Top - line, sheet.Faint());
    return;
  }
  // Few frames do not fill the plot, so that columns keep their width while they arrive.
  const int slots = std::min(most, count <= 30 ? 30 : count <= 60 ? 60 : MostFrames);
  Columns columns{ data, plot, plot.Height() / range,
    std::max(1.0, std::floor(plot.Width() / slots)), 0.0, first, count };
  columns.Gap = columns.Pitch >= 8.0 ? 1.0 : 0.0;
  plot.Left = plot.Right - slots * columns.Pitch;
  DrawColumns(sheet, columns);
  const int late = MarkLateFrames(sheet, columns, budget);
  DrawAxis(sheet, plot, range, columns.Scale, budget);
  const double below = plot.Bottom - line - 1.0;
  sheet.Text("now", plot.Right, below, sheet.Faint(), 1.0);
  sheet.Text(std::to_string(count) + (count == 1 ? " frame" : " frames"), columns.Left(0), below,
    sheet.Faint());
  if (sheet.Text("Frames", box.Left, box.Top - line, sheet.Ink()) && budget > 0.0)
  {
    sheet.Text(late == 0 ? "none over budget" : std::to_string(late) + " over budget",
      box.Left + sheet.TextWidth("Frames") + 0.8 * size, box.Top - line,
      late == 0 ? sheet.Faint() : sheet.Alarm());
  }
}
}
