// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Shapes of a chart while they are being laid out, and the parts of the chart.
#pragma once

#include "instrument/FrameChartLayout.h"

#include <utility>

namespace penumbra
{
/// Durations have as many digits as matter to a frame: 0.04, 4.2, 142.
std::string FormatMilliseconds(double milliseconds);

/// Distance between ticks, 1, 2 or 5 times a power of ten, for at most the given number of ticks.
double TickStep(double range, int most);

class ChartSheet
{
public:
  explicit ChartSheet(const ChartStyle& style);

  ChartColor Ink() const;
  ChartColor Faint() const; ///< axes and secondary text
  ChartColor Alarm() const; ///< the budget
  ChartColor Paper() const;
  /// The colour of a approach. Neighbouring passes alternate between two shades.
  ChartColor Color(Approach approach, bool lighter = false) const;
  /// The colour of a approach for text on the page.
  ChartColor InkOf(Approach approach) const;
  /// Black or white, whichever is easier to read on a colour.
  static ChartColor InkOn(const ChartColor& color);

  double FontSize() const { return this->Font; }
  /// Whole pixels, so that lines of text keep their distance when they are rounded to pixels.
  double LineHeight() const;
  double TextWidth(const std::string& text) const;

  void Rectangle(ChartRole role, const ChartBox& box, const ChartColor& color, double value = 0.0,
    const std::string& description = "");
  void Line(ChartRole role, double x0, double y0, double x1, double y1, const ChartColor& color,
    double width = 1.0);
  void Disc(ChartRole role, double x, double y, double radius, const ChartColor& color,
    const std::string& description = "");
  /// Text from x to the right (align 0), around x (0.5) or to the left (1), on y. Returns false if there is no room.
  /// With a veil, what is drawn below pales.
  bool Text(const std::string& text, double x, double y, const ChartColor& color,
    double align = 0.0, bool veil = false);
  /// Later texts avoid the box.
  void Reserve(const ChartBox& box) { this->Occupied.push_back(box); }

  const ChartStyle& Style() const { return this->Asked; }
  std::vector<ChartShape> Take() { return std::move(this->Shapes); }

private:
  ChartStyle Asked;
  double Font = 0.0;
  std::vector<ChartShape> Shapes;
  std::vector<ChartBox> Occupied;
};

/// The bar of the frame's passes above its axis.
void LayOutBar(ChartSheet& sheet, const FrameChartData& data, const ChartBox& box);
/// Earlier frames.
void LayOutHistory(ChartSheet& sheet, const FrameChartData& data, const ChartBox& box);
/// Each level of each knob: its error over its cost.
void LayOutKnobs(ChartSheet& sheet, const FrameChartData& data, const ChartBox& box);

/// Milliseconds of a frame by approach. What the passes leave of the frame is rest.
std::array<double, ApproachCount> SumApproaches(const FrameChartData& data);
}
