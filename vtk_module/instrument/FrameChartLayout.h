// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Where everything in a chart of a frame's cost goes: shapes in pixels, without any drawing.
#pragma once

#include "instrument/FrameChartData.h"

#include <functional>
#include <string>
#include <vector>

namespace penumbra
{
struct ChartColor
{
  double Red = 0.0;
  double Green = 0.0;
  double Blue = 0.0;
  double Alpha = 1.0;
};

/// A rectangle in pixels; y goes up.
struct ChartBox
{
  double Left = 0.0;
  double Bottom = 0.0;
  double Right = 0.0;
  double Top = 0.0;

  double Width() const { return this->Right - this->Left; }
  double Height() const { return this->Top - this->Bottom; }
  bool Overlaps(const ChartBox& other) const
  {
    return this->Left < other.Right && other.Left < this->Right && this->Bottom < other.Top &&
      other.Bottom < this->Top;
  }
};

enum class ChartKind
{
  Rectangle,
  Line, ///< from Left, Bottom to Right, Top of the box
  Disc, ///< in the box
  Text  ///< from the left edge of the box, with descenders on its bottom edge
};

/// What a shape stands for.
enum class ChartRole
{
  Page,
  Bar,    ///< a pass, or several thin ones, of the frame
  Column, ///< a approach's share of an earlier frame
  Level,  ///< a level of a knob
  Force,  ///< the level in force
  Budget,
  Over, ///< marks an earlier frame that exceeded the budget
  Key,  ///< of the legend
  Axis,
  Label
};

struct ChartShape
{
  ChartKind Kind = ChartKind::Rectangle;
  ChartRole Role = ChartRole::Label;
  ChartBox Box;
  ChartColor Color;
  /// A line's width, or the size of text, in pixels.
  double Size = 0.0;
  /// The text; for other shapes a description, as a tool tip.
  std::string Text;
  /// Milliseconds of a bar or column.
  double Value = 0.0;
};

/// The width in pixels of text of a size.
using TextMeasure = std::function<double(const std::string&, double)>;

/// Widths of the widest among the usual sans-serif fonts (DejaVu Sans), so that text fits whatever a viewer substitutes.
double EstimateTextWidth(const std::string& text, double size);

struct ChartStyle
{
  int Width = 0;
  int Height = 0;
  /// A dark translucent panel instead of a white page.
  bool Panel = false;
  std::string Title;
  TextMeasure Measure = EstimateTextWidth;
};

/// Shapes in the order of drawing. No two texts overlap, and none leaves the page: text without room is left out. The bars
/// cover the frame without gaps; passes narrower than two pixels share a bar.
std::vector<ChartShape> LayOutFrameChart(const FrameChartData& data, const ChartStyle& style);
}
