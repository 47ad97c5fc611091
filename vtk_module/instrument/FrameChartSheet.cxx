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
ChartColor Mix(const ChartColor& a, const ChartColor& b, double share)
{
  return { a.Red + (b.Red - a.Red) * share, a.Green + (b.Green - a.Green) * share,
    a.Blue + (b.Blue - a.Blue) * share, a.Alpha };
}
}

double EstimateTextWidth(const std::string& text, double size)
{
  double width = 0.0;
  for (const unsigned char character : text)
  {
    const std::string one(1, static_cast<char>(character));
    const auto among = [&one](const char* set) {
      return std::string(set).find(one) != std::string::npos;
    };
    if ((character & 0xc0) == 0x80)
    {
      continue; // counted with its first byte
    }
    // In units of the size, rounded up.
    if (character >= 128)
    {
      width += 1.0;
    }
    else if (among(" ijl.,'|:;!/\\I-()[]"))
    {
      width += among(" .,'") ? 0.32 : among("()[]I-/\\!") ? 0.41 : 0.34;
    }
    else if (among("frt"))
    {
      width += 0.41;
    }
    else if (among("mwMW%@=+<>#~&"))
    {
      width += among("mM%@W") ? 1.0 : 0.84;
    }
    else
    {
      width += character >= 'A' && character <= 'Z' ? 0.79 : 0.64;
    }
  }
  return width * size;
}

std::string FormatMilliseconds(double milliseconds)
{
  milliseconds = Drawable(milliseconds);
  const char* format = milliseconds >= 99950.0     ? "%.3g"
    : milliseconds >= 99.95                        ? "%.0f"
    : milliseconds >= 0.095 || milliseconds == 0.0 ? "%.1f"
    : milliseconds >= 0.0095                       ? "%.2f"
                                                   : "%.0e";
  char text[32];
  std::snprintf(text, sizeof(text), format, milliseconds);
  return text;
}

double TickStep(double range, int most)
{
  const double least = range / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= least)
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

ChartSheet::ChartSheet(const ChartStyle& style)
  : Asked(style)
{
  // From 11 pixels in an overlay of 200 rows to 14 in a plot of 500.
  this->Font =
    std::round(std::clamp(9.0 + std::min(style.Height / 100.0, style.Width / 240.0), 10.0, 18.0));
  const ChartBox page{ 0.0, 0.0, static_cast<double>(style.Width),
    static_cast<double>(style.Height) };
  ChartColor color = this->Paper();
  color.Alpha = style.Panel ? 0.8 : 1.0;
  this->Rectangle(ChartRole::Page, page, color);
}

ChartColor ChartSheet::Paper() const
{
  return this->Asked.Panel ? ChartColor{ 0.07, 0.08, 0.09 } : ChartColor{ 1.0, 1.0, 1.0 };
}

ChartColor ChartSheet::Ink() const
{
  return this->Asked.Panel ? ChartColor{ 0.93, 0.93, 0.93 } : ChartColor{ 0.13, 0.13, 0.13 };
}

ChartColor ChartSheet::Faint() const
{
  return this->Asked.Panel ? ChartColor{ 0.66, 0.66, 0.66 } : ChartColor{ 0.4, 0.4, 0.4 };
}

ChartColor ChartSheet::Alarm() const
{
  return this->Asked.Panel ? ChartColor{ 1.0, 0.36, 0.3 } : ChartColor{ 0.8, 0.08, 0.1 };
}

ChartColor ChartSheet::Color(Approach approach, bool lighter) const
{
  // Blue, orange and bluish green of Okabe and Ito's palette, which colour-blind people tell apart.
  constexpr std::array<ChartColor, ApproachCount> palette = { ChartColor{ 0.0, 0.447, 0.698 },
    ChartColor{ 0.902, 0.624, 0.0 }, ChartColor{ 0.0, 0.62, 0.451 },
    ChartColor{ 0.62, 0.62, 0.62 } };
  const ChartColor& color = palette[static_cast<int>(approach)];
  return lighter ? Mix(color, { 1.0, 1.0, 1.0 }, 0.2) : color;
}

ChartColor ChartSheet::InkOf(Approach approach) const
{
  // Lighter on the dark panel and darker on the page, so that thin strokes have contrast.
  const double end = this->Asked.Panel ? 1.0 : 0.0;
  return Mix(this->Color(approach), { end, end, end }, 0.4);
}

ChartColor ChartSheet::InkOn(const ChartColor& color)
{
  const double luma = 0.299 * color.Red + 0.587 * color.Green + 0.114 * color.Blue;
  return luma > 0.38 ? ChartColor{ 0.0, 0.0, 0.0 } : ChartColor{ 1.0, 1.0, 1.0 };
}

double ChartSheet::LineHeight() const
{
  return std::round(1.25 * this->Font);
}

double ChartSheet::TextWidth(const std::string& text) const
{
  return this->Asked.Measure(text, this->Font);
}

void ChartSheet::Rectangle(ChartRole role, const ChartBox& box, const ChartColor& color,
  double value, const std::string& description)
{
  this->Shapes.push_back({ ChartKind::Rectangle, role, box, color, 0.0, description, value });
}

void ChartSheet::Line(
  ChartRole role, double x0, double y0, double x1, double y1, const ChartColor& color, double width)
{
  this->Shapes.push_back({ ChartKind::Line, role, { x0, y0, x1, y1 }, color, width, "", 0.0 });
}

void ChartSheet::Disc(ChartRole role, double x, double y, double radius, const ChartColor& color,
  const std::string& description)
{
  const ChartBox box{ x - radius, y - radius, x + radius, y + radius };
  this->Shapes.push_back({ ChartKind::Disc, role, box, color, 0.0, description, 0.0 });
}

bool ChartSheet::Text(
  const std::string& text, double x, double y, const ChartColor& color, double align, bool veil)
{
  const double width = this->TextWidth(text);
  const double left = std::round(x - align * width);
  y = std::round(y);
  const ChartBox box{ left, y, left + width, y + this->LineHeight() };
  // A little space to the left and the right keeps neighbours apart.
  const double apart = 0.3 * this->Font;
  const ChartBox needed{ left - apart, y, left + width + apart, box.Top };
  const bool inside =
    left >= 0.0 && y >= 0.0 && box.Right <= this->Asked.Width && box.Top <= this->Asked.Height;
  const auto overlaps = [&needed](const ChartBox& other) { return needed.Overlaps(other); };
  if (text.empty() || !inside ||
    std::any_of(this->Occupied.begin(), this->Occupied.end(), overlaps))
  {
    return false;
  }
  this->Occupied.push_back(box);
  if (veil)
  {
    ChartColor paper = this->Paper();
    paper.Alpha = 0.75;
    this->Rectangle(ChartRole::Label, box, paper);
  }
  this->Shapes.push_back({ ChartKind::Text, ChartRole::Label, box, color, this->Font, text, 0.0 });
  return true;
}
}
