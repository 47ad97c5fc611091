// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instrument/FrameChartLabels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra
{
namespace
{
/// Whether a line from a to b crosses a box.
bool Crosses(const ChartBox& line, const ChartBox& box)
{
  // The part of the line within the box, from 0 to 1 (Liang and Barsky's clipping).
  double from = 0.0;
  double to = 1.0;
  const double dx = line.Right - line.Left;
  const double dy = line.Top - line.Bottom;
  const double slopes[] = { -dx, dx, -dy, dy };
  const double distances[] = { line.Left - box.Left, box.Right - line.Left,
    line.Bottom - box.Bottom, box.Top - line.Bottom };
  for (int i = 0; i < 4; ++i)
  {
    if (slopes[i] == 0.0 && distances[i] < 0.0)
    {
      return false;
    }
    const double at = slopes[i] == 0.0 ? 0.0 : distances[i] / slopes[i];
    from = slopes[i] < 0.0 ? std::max(from, at) : from;
    to = slopes[i] > 0.0 ? std::min(to, at) : to;
  }
  return from <= to;
}

/// Puts a label next to a point where there is room, and where the fewest lines cross it.
bool LabelPoint(ChartSheet& sheet, const std::string& text, const ChartColor& ink, double x,
  double y, double radius, const ChartBox& plot, const std::vector<ChartBox>& lines)
{
  const double line = sheet.LineHeight();
  const double width = sheet.TextWidth(text);
  const double away = radius + 0.45 * sheet.FontSize();
  // From the right of the point, the best place, around it and further away.
  std::vector<std::pair<long, ChartBox>> places;
  for (const double up : { 0.0, 0.8, -0.8, 1.4, -1.4, 2.2, -2.2 })
  {
    for (const double right : { 1.0, 0.0, -1.0 })
    {
      const double bottom = y + up * line - 0.5 * line;
      const double left =
        x + right * (std::abs(up) < 1.0 ? away : 0.3 * away) - 0.5 * width * (1.0 - right);
      const ChartBox box{ left, bottom, left + width, bottom + line };
      const bool inside = box.Left >= plot.Left && box.Right <= plot.Right &&
        box.Bottom >= plot.Bottom && box.Top <= plot.Top + line;
      if (inside)
      {
        places.emplace_back(std::count_if(lines.begin(), lines.end(),
                              [&box](const ChartBox& other) { return Crosses(other, box); }),
          box);
      }
    }
  }
  std::stable_sort(
    places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& place : places)
  {
    const ChartBox& label = place.second;
    if (sheet.Text(text, label.Left, label.Bottom, ink, 0.0, place.first > 0))
    {
      // A line leads to a label that is not next to its point.
      const double toX = std::clamp(x, label.Left, label.Right);
      const double toY = std::clamp(y, label.Bottom, label.Top);
      const double distance = std::hypot(toX - x, toY - y);
      if (distance > radius + 0.4 * line)
      {
        const double start = (radius + 1.0) / distance;
        sheet.Line(
          ChartRole::Label, x + start * (toX - x), y + start * (toY - y), toX, toY, ink, 1.0);
      }
      return true;
    }
  }
  return false;
}
/// Labels the points in this order. Returns how well it went: 2 for each complete label, 1 for a shorter one.
int LabelPoints(ChartSheet& sheet, const std::vector<ChartPoint>& points, double radius,
  const ChartBox& plot, const std::vector<ChartBox>& lines)
{
  int success = 0;
  for (const ChartPoint& point : points)
  {
    const ChartColor ink = sheet.InkOf(point.Payment);
    const std::string text = point.Name + " " + point.Level;
    if (LabelPoint(sheet, text, ink, point.X, point.Y, radius, plot, lines))
    {
      success += 2;
    }
    else if (LabelPoint(sheet, point.Name, ink, point.X, point.Y, radius, plot, lines))
    {
      success += 1;
    }
  }
  return success;
}
}

void LabelInBestOrder(ChartSheet& sheet, std::vector<ChartPoint> points, double radius,
  const ChartBox& plot, const std::vector<ChartBox>& lines)
{
  ChartSheet best = sheet;
  int most = -1;
  for (int order = 0; order < 4; ++order)
  {
    if (order == 2)
    {
      std::stable_sort(points.begin(), points.end(),
        [](const ChartPoint& a, const ChartPoint& b) { return a.X < b.X; });
    }
    else if (order > 0)
    {
      std::reverse(points.begin(), points.end());
    }
    ChartSheet attempt = sheet;
    const int success = LabelPoints(attempt, points, radius, plot, lines);
    if (success > most)
    {
      most = success;
      best = std::move(attempt);
    }
  }
  sheet = std::move(best);
}
}
