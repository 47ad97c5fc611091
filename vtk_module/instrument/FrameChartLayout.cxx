// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instrument/FrameChartLayout.h"

#include "instrument/FrameChartSheet.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
struct LegendEntry
{
  std::string Text;
  Approach Payment = Approach::Rest;
};

/// The approaches with their sums, or without if that would be too long.
std::vector<LegendEntry> MakeLegend(const FrameChartData& data, bool sums)
{
  const std::array<double, ApproachCount> totals = SumApproaches(data);
  std::vector<LegendEntry> entries;
  for (int i = 0; i < ApproachCount; ++i)
  {
    const auto approach = static_cast<Approach>(i);
    const std::string sum = sums ? " " + FormatMilliseconds(totals[i]) : "";
    entries.push_back({ ApproachName(approach) + sum, approach });
  }
  return entries;
}

double EntryWidth(const ChartSheet& sheet, const LegendEntry& entry)
{
  return sheet.TextWidth(entry.Text) + 2.2 * sheet.FontSize();
}

double LegendWidth(const ChartSheet& sheet, const std::vector<LegendEntry>& entries)
{
  double width = 0.0;
  for (const LegendEntry& entry : entries)
  {
    width += EntryWidth(sheet, entry);
  }
  return width - sheet.FontSize(); // no gap after the last
}

void DrawLegend(ChartSheet& sheet, const std::vector<LegendEntry>& entries, double x, double y)
{
  const double size = sheet.FontSize();
  for (const LegendEntry& entry : entries)
  {
    if (sheet.Text(entry.Text, x + 1.1 * size, y, sheet.Ink()))
    {
      const double bottom = std::round(y + 0.25 * size);
      const double side = std::round(0.75 * size);
      sheet.Rectangle(
        ChartRole::Key, { x, bottom, x + side, bottom + side }, sheet.Color(entry.Payment));
    }
    x += EntryWidth(sheet, entry);
  }
}

/// What the chart says in words, the most important first.
std::vector<std::string> Headlines(const FrameChartData& data, const std::string& title)
{
  double frame = 0.0;
  for (const double milliseconds : SumApproaches(data))
  {
    frame += milliseconds;
  }
  const std::string cost = FormatMilliseconds(frame) + " ms";
  const std::string ofBudget = data.HasBudget && data.Budget > 0.0
    ? cost + " of " + FormatMilliseconds(Drawable(data.Budget))
    : cost;
  const std::string state = data.State.empty() ? "" : ", " + data.State;
  const std::string prefix = title.empty() ? "Frame: " : title + ": ";
  return { prefix + ofBudget + state, prefix + ofBudget, ofBudget, cost };
}

/// The headline and the legend, in one row if they fit. Returns the bottom of the header.
double LayOutHeader(
  ChartSheet& sheet, const FrameChartData& data, double left, double right, double top)
{
  const double line = sheet.LineHeight();
  const double width = right - left;
  const auto headlines = Headlines(data, sheet.Style().Title);
  const auto fitting = std::find_if(headlines.begin(), headlines.end(),
    [&](const std::string& text) { return sheet.TextWidth(text) <= width; });
  const double used = fitting == headlines.end() ? 0.0 : sheet.TextWidth(*fitting);
  if (fitting != headlines.end())
  {
    sheet.Text(*fitting, left, top - line, sheet.Ink());
  }
  const auto sums = MakeLegend(data, true);
  const double wide = LegendWidth(sheet, sums);
  if (used + 2.0 * sheet.FontSize() + wide <= width)
  {
    DrawLegend(sheet, sums, right - wide, top - line);
    return top - line;
  }
  const auto names = MakeLegend(data, false);
  const bool enough = wide <= width;
  if (enough || LegendWidth(sheet, names) <= width)
  {
    DrawLegend(sheet, enough ? sums : names, left, top - 2.2 * line);
    return top - 2.2 * line;
  }
  return top - line;
}
}

std::vector<ChartShape> LayOutFrameChart(const FrameChartData& data, const ChartStyle& style)
{
  ChartSheet sheet(style);
  const double size = sheet.FontSize();
  const double line = sheet.LineHeight();
  const double margin = std::round(0.8 * size);
  const double left = margin;
  const double right = style.Width - margin;
  const double top = style.Height - margin;
  if (right - left < 4.0 * size || top - margin < 2.0 * line)
  {
    return sheet.Take(); // no room for anything
  }
  const double header = LayOutHeader(sheet, data, left, right, top);
  const double room = header - margin;
  // A bar of one or two lines of text, with a label above and an axis below.
  const double around = 3.0 * line;
  const double barHeight = std::clamp(0.15 * style.Height, 2.0 * line, 4.0 * line);
  const double gap = 0.3 * line;
  const bool plots = data.HasBudget && room - around - barHeight - gap >= 5.0 * line;
  const double barBottom =
    plots ? header - around - barHeight : std::max(margin, header - around - 6.0 * line);
  if (barBottom + around < header)
  {
    LayOutBar(sheet, data, { left, barBottom, right, header - 0.2 * line });
  }
  if (plots)
  {
    const ChartBox below{ left, margin, right, barBottom - gap };
    const bool knobs = !data.Knobs.empty() && below.Width() >= 32.0 * size;
    const double middle = std::floor(0.5 * (left + right));
    LayOutHistory(
      sheet, data, { below.Left, below.Bottom, knobs ? middle - size : below.Right, below.Top });
    if (knobs)
    {
      LayOutKnobs(sheet, data, { middle + size, below.Bottom, below.Right, below.Top });
    }
  }
  return sheet.Take();
}
}
