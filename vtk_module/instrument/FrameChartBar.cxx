// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instrument/FrameChartSheet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace penumbra
{
namespace
{
/// Thinner bars would not be seen.
constexpr double LeastWidth = 2.0;

/// A pass, or several.
struct Segment
{
  Approach Payment = Approach::Rest;
  std::string Name;  ///< of the pass
  std::string Label; ///< shared by neighbours: the technique, or else the pass
  double Milliseconds = 0.0;
  double Width = 0.0; ///< in pixels
};

/// The passes of a approach, those of one technique next to each other, in the order in which they appear in the frame, so
/// that nothing changes place while one watches.
std::vector<Segment> PassesOf(const FrameChartData& data, Approach approach)
{
  std::vector<Segment> found;
  for (const ChartPass& pass : data.Passes)
  {
    const double milliseconds = Drawable(pass.Milliseconds);
    if (pass.Payment != approach || milliseconds <= 0.0)
    {
      continue;
    }
    const std::string label = pass.Technique.empty() ? pass.Name : pass.Technique;
    const auto last = std::find_if(found.rbegin(), found.rend(),
      [&label](const Segment& segment) { return segment.Label == label; });
    const auto place = last == found.rend() ? found.end() : last.base();
    found.insert(place, { approach, pass.Name, label, milliseconds, 0.0 });
  }
  return found;
}

/// Joins the passes that are too thin into one segment at the end.
void JoinThin(std::vector<Segment>& segments, double scale)
{
  Segment joined;
  int count = 0;
  for (Segment& segment : segments)
  {
    segment.Width = segment.Milliseconds * scale;
    if (segment.Width < LeastWidth)
    {
      ++count;
      joined.Payment = segment.Payment;
      joined.Name = segment.Name;
      joined.Milliseconds += segment.Milliseconds;
    }
  }
  if (count == 0)
  {
    return;
  }
  const auto thin = [](const Segment& segment) { return segment.Width < LeastWidth; };
  segments.erase(std::remove_if(segments.begin(), segments.end(), thin), segments.end());
  joined.Name = count > 1 ? std::to_string(count) + " short passes" : joined.Name;
  joined.Width = joined.Milliseconds * scale;
  segments.push_back(joined);
}

std::vector<Segment> MakeSegments(const FrameChartData& data, double scale)
{
  double sum = 0.0;
  std::vector<Segment> segments;
  for (int i = 0; i < ApproachCount; ++i)
  {
    std::vector<Segment> some = PassesOf(data, static_cast<Approach>(i));
    for (const Segment& segment : some)
    {
      sum += segment.Milliseconds;
    }
    // More than rounding.
    const double outside = Drawable(data.Frame) - sum;
    if (i == static_cast<int>(Approach::Rest) && outside > 1e-6 * sum)
    {
      some.push_back({ Approach::Rest, "outside the passes", "outside the passes", outside, 0.0 });
    }
    JoinThin(some, scale);
    segments.insert(segments.end(), some.begin(), some.end());
  }
  // What widens a thin segment is taken from the widest, so that the frame ends where it should.
  double borrowed = 0.0;
  for (Segment& segment : segments)
  {
    const double width = std::max(segment.Width, LeastWidth);
    borrowed += width - segment.Width;
    segment.Width = width;
  }
  const auto widest = std::max_element(segments.begin(), segments.end(),
    [](const Segment& a, const Segment& b) { return a.Width < b.Width; });
  if (widest != segments.end())
  {
    widest->Width = std::max(LeastWidth, widest->Width - borrowed);
  }
  return segments;
}

/// The words of a name in lines that fit; none if a word does not.
std::vector<std::string> Wrap(const ChartSheet& sheet, const std::string& name, double width)
{
  std::vector<std::string> lines;
  std::istringstream words(name);
  for (std::string word; words >> word;)
  {
    if (sheet.TextWidth(word) > width)
    {
      return {};
    }
    if (!lines.empty() && sheet.TextWidth(lines.back() + " " + word) <= width)
    {
      lines.back() += " " + word;
    }
    else
    {
      lines.push_back(word);
    }
  }
  return lines;
}

void LabelRun(ChartSheet& sheet, const Segment& first, double milliseconds, const ChartBox& box)
{
  const double line = sheet.LineHeight();
  const double room = box.Width() - 0.6 * sheet.FontSize();
  const auto most = static_cast<std::size_t>(std::max(0.0, box.Height() / line));
  std::string name = first.Label;
  std::replace(name.begin(), name.end(), '_', ' ');
  const std::string value = FormatMilliseconds(milliseconds);
  // The name with its milliseconds, or else the name alone.
  std::vector<std::string> lines = Wrap(sheet, name, room);
  if (most == 1 && lines.size() == 1 && sheet.TextWidth(name + " " + value) <= room)
  {
    lines = { name + " " + value };
  }
  else if (!lines.empty() && lines.size() < most)
  {
    lines.push_back(value);
  }
  if (lines.size() > most)
  {
    return;
  }
  double y = std::round(0.5 * (box.Bottom + box.Top + static_cast<double>(lines.size()) * line));
  for (const std::string& text : lines)
  {
    y -= line;
    const ChartColor ink = ChartSheet::InkOn(sheet.Color(first.Payment));
    sheet.Text(text, 0.5 * (box.Left + box.Right), y, ink, 0.5);
  }
}

void DrawSegments(ChartSheet& sheet, const std::vector<Segment>& segments, const ChartBox& box)
{
  double left = box.Left;
  for (std::size_t i = 0; i < segments.size();)
  {
    const Segment& first = segments[i];
    const double start = left;
    double milliseconds = 0.0;
    // A run of passes has one label.
    for (bool lighter = false; i < segments.size() && segments[i].Label == first.Label &&
         segments[i].Payment == first.Payment;
         ++i, lighter = !lighter)
    {
      const Segment& segment = segments[i];
      const std::string description = segment.Name + ": " +
        FormatMilliseconds(segment.Milliseconds) + " ms, " + ApproachName(segment.Payment);
      sheet.Rectangle(ChartRole::Bar, { left, box.Bottom, left + segment.Width, box.Top },
        sheet.Color(segment.Payment, lighter), segment.Milliseconds, description);
      left += segment.Width;
      milliseconds += segment.Milliseconds;
    }
    if (start > box.Left)
    {
      sheet.Line(ChartRole::Axis, start, box.Bottom, start, box.Top, sheet.Paper());
    }
    LabelRun(sheet, first, milliseconds, { start, box.Bottom, left, box.Top });
  }
}

void DrawAxis(ChartSheet& sheet, const ChartBox& box, double range, double scale)
{
  const double length = 0.35 * sheet.FontSize();
  const ChartColor faint = sheet.Faint();
  sheet.Line(ChartRole::Axis, box.Left, box.Bottom, box.Right, box.Bottom, faint);
  const double widest = sheet.TextWidth(FormatMilliseconds(range)) + 2.0 * sheet.FontSize();
  const double step = TickStep(range, std::clamp(static_cast<int>(box.Width() / widest), 2, 10));
  for (int i = 0; i * step <= range; ++i)
  {
    const double x = box.Left + i * step * scale;
    sheet.Line(ChartRole::Axis, x, box.Bottom, x, box.Bottom - length, faint);
    char text[32];
    std::snprintf(text, sizeof(text), "%.6g", i * step);
    const std::string label = i == 0 ? "0 ms" : text;
    sheet.Text(label, x, box.Bottom - length - sheet.LineHeight(), faint, i == 0 ? 0.0 : 0.5);
  }
}
}

void LayOutBar(ChartSheet& sheet, const FrameChartData& data, const ChartBox& box)
{
  const double line = sheet.LineHeight();
  const double budget = data.HasBudget ? Drawable(data.Budget) : 0.0;
  double frame = 0.0;
  for (const double milliseconds : SumApproaches(data))
  {
    frame += milliseconds;
  }
  const double longest = std::max(frame, budget);
  if (longest <= 0.0)
  {
    sheet.Text("No times were measured.", box.Left, box.Top - 2.0 * line, sheet.Faint());
    return;
  }
  const double range = 1.04 * longest;
  // Above the bar is the budget's label, below it the axis.
  const ChartBox bar{ box.Left, box.Bottom + 1.6 * line, box.Right,
    box.Top - (budget > 0.0 ? line + 2.0 : 0.0) };
  const double scale = bar.Width() / range;
  DrawSegments(sheet, MakeSegments(data, scale), bar);
  DrawAxis(sheet, bar, range, scale);
  if (budget > 0.0)
  {
    const double x = bar.Left + budget * scale;
    sheet.Line(ChartRole::Budget, x, bar.Bottom - 3.0, x, bar.Top + 3.0, sheet.Paper(), 5.0);
    sheet.Line(ChartRole::Budget, x, bar.Bottom - 4.0, x, bar.Top + 4.0, sheet.Alarm(), 2.0);
    const std::string label = FormatMilliseconds(budget) + " ms";
    const std::string longer = "budget " + label;
    const double width = sheet.TextWidth(longer);
    // At the line, but within the page.
    const double left =
      std::clamp(x - 0.5 * width, bar.Left, std::max(bar.Left, box.Right - width));
    if (!sheet.Text(longer, left, bar.Top + 3.0, sheet.Alarm()))
    {
      sheet.Text(label, x, bar.Top + 3.0, sheet.Alarm(), 0.5);
    }
  }
  // What no knob can save.
  const double floor = data.HasBudget ? Drawable(data.Floor) : 0.0;
  if (floor > 0.0 && floor < range)
  {
    const double x = bar.Left + floor * scale;
    if (sheet.Text("least " + FormatMilliseconds(floor), x, bar.Top + 3.0, sheet.Faint(), 0.5))
    {
      sheet.Line(ChartRole::Axis, x, bar.Top, x, bar.Top + 4.0, sheet.Faint(), 1.0);
    }
  }
}

std::array<double, ApproachCount> SumApproaches(const FrameChartData& data)
{
  std::array<double, ApproachCount> sums{};
  double sum = 0.0;
  for (const ChartPass& pass : data.Passes)
  {
    const double milliseconds = Drawable(pass.Milliseconds);
    sums[static_cast<int>(pass.Payment)] += milliseconds;
    sum += milliseconds;
  }
  const double outside = Drawable(data.Frame) - sum;
  sums[static_cast<int>(Approach::Rest)] += outside > 1e-6 * sum ? outside : 0.0;
  return sums;
}
}
