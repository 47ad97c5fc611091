// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/BiasSheet.h"

#include "lab/BiasReport.h"
#include "lab/Canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
constexpr int Enlarged = 2;
constexpr int Gutter = 14; // between tiles, frames included
constexpr int FrameWidth = 4;
constexpr int Margin = 16;
constexpr int TitleSize = 18;
constexpr int TextSize = 13;
constexpr int LineHeight = 18;
constexpr int LegendWidth = 180;
constexpr int HeadingWidth = 940;
constexpr std::size_t MostColumns = 8;

constexpr Canvas::Color Ink = { 0.1f, 0.1f, 0.1f };
constexpr Canvas::Color AcneColor = { 0.8f, 0.16f, 0.12f };
constexpr Canvas::Color GapColor = { 0.12f, 0.36f, 0.75f };
constexpr Canvas::Color SafeColor = { 0.2f, 0.6f, 0.25f };
constexpr Canvas::Color TrueColor = { 0.55f, 0.55f, 0.55f };

/// Of many samples some, evenly, but the best one of all.
std::vector<std::size_t> ChooseColumns(const BiasSweep& sweep, const BiasLimits& limits)
{
  const std::size_t count = sweep.Samples.size();
  const std::size_t columns = std::min(count, MostColumns);
  const auto best = static_cast<std::size_t>(&sweep.Best(limits) - sweep.Samples.data());
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < columns; ++i)
  {
    chosen.push_back(columns < 2 ? 0 : (i * (count - 1) + (columns - 1) / 2) / (columns - 1));
  }
  const auto nearest =
    std::min_element(chosen.begin(), chosen.end(), [best](std::size_t a, std::size_t b) {
      return std::max(a, best) - std::min(a, best) < std::max(b, best) - std::min(b, best);
    });
  *nearest = best;
  return chosen;
}

const Canvas::Color& Verdict(const BiasErrors& errors, const BiasLimits& limits)
{
  const double acne = errors.Acne / limits.Acne, gap = errors.Gap() / limits.Gap;
  return acne <= 1 && gap <= 1 ? SafeColor : acne > gap ? AcneColor : GapColor;
}

struct Layout
{
  int Tile, Columns;
  explicit Layout(const BiasStudy& study)
    : Tile(Enlarged * study.AcnePlace.Width)
    , Columns(0)
  {
    for (const BiasSweep& sweep : study.Sweeps)
    {
      this->Columns =
        std::max(this->Columns, static_cast<int>(std::min(sweep.Samples.size(), MostColumns)) + 1);
    }
  }
  int Width() const { return 2 * Margin + this->Columns * (this->Tile + Gutter) - Gutter; }
  int Height() const
  {
    return 2 * LineHeight + 2 * (this->Tile + Gutter) + 3 * LineHeight + Margin;
  }
  int Left(int column) const { return Margin + column * (this->Tile + Gutter); }
};

void DrawColumn(Canvas& canvas, int x, int y, int tile, const Picture& acne, const Picture& gap,
  const Canvas::Color& frame, const std::vector<std::string>& caption)
{
  for (const Picture* picture : { &acne, &gap })
  {
    canvas.Frame(x, y, tile, tile, FrameWidth, frame);
    canvas.Place(*picture, x, y, Enlarged);
    y += tile + Gutter;
  }
  for (const std::string& line : caption)
  {
    canvas.Write(line, x, y, TextSize, &line == &caption.front() ? frame : Ink);
    y += LineHeight;
  }
}

void DrawStripOn(Canvas& canvas, int top, const BiasStudy& study, std::size_t index)
{
  const Layout layout(study);
  const BiasSweep& sweep = study.Sweeps[index];
  const BiasLimits& limits = study.Options.Limits;
  canvas.Write(fmt::format("{} bias: {}", sweep.Kind, SummarizeWindow(sweep, limits)), Margin, top,
    TitleSize, Ink);
  const int y = top + 2 * LineHeight;
  int column = 0;
  for (const std::size_t i : ChooseColumns(sweep, limits))
  {
    const BiasErrors& errors = sweep.Samples[i].Errors;
    DrawColumn(canvas, layout.Left(column++), y, layout.Tile, study.Strips[index][i].AcnePlace,
      study.Strips[index][i].GapPlace, Verdict(errors, limits),
      { fmt::format("{:.3g} texels", sweep.Samples[i].Bias), "acne " + FormatPercent(errors.Acne),
        fmt::format("gap {:.2f} texels", errors.Gap()) });
  }
  DrawColumn(canvas, layout.Left(column), y, layout.Tile, Cut(study.Overview, study.AcnePlace),
    Cut(study.Overview, study.GapPlaces[index]), TrueColor, { "by rays" });
}

/// The whole view by rays, with the places of the strips, and by the map as it was set.
void DrawOverviews(Canvas& canvas, int top, const BiasStudy& study)
{
  const int step = study.Overview.Width + Margin;
  canvas.Write("by rays", Margin, top, TextSize, Ink);
  canvas.Write("by the map, " + SummarizeDefaults(study), Margin + step, top, TextSize, Ink);
  const int y = top + LineHeight;
  canvas.Place(study.Overview, Margin, y);
  canvas.Place(study.OverviewAtDefaults, Margin + step, y);
  const auto mark = [&](const Crop& crop, const Canvas::Color& color) {
    canvas.Frame(Margin + crop.X, y + crop.Y, crop.Width, crop.Height, 2, color);
  };
  mark(study.AcnePlace, AcneColor);
  for (const Crop& place : study.GapPlaces)
  {
    mark(place, GapColor);
  }
  const int beside = Margin + 2 * step;
  canvas.Write("upper row: worst acne", beside, y, TextSize, AcneColor);
  canvas.Write("lower row: widest gap", beside, y + LineHeight, TextSize, GapColor);
  canvas.Write("green frames: neither", beside, y + 2 * LineHeight, TextSize, SafeColor);
}
}

Picture DrawStrip(const BiasStudy& study, std::size_t sweep)
{
  const Layout layout(study);
  Canvas canvas(layout.Width(), Margin + layout.Height());
  DrawStripOn(canvas, Margin, study, sweep);
  return canvas.Get();
}

Picture DrawSheet(const BiasStudy& study, const Picture& plot)
{
  const Layout layout(study);
  const int overviews = 2 * (study.Overview.Width + Margin);
  const int width = std::max(
    { layout.Width(), 2 * Margin + plot.Width, Margin + overviews + LegendWidth, HeadingWidth });
  const int strips = static_cast<int>(study.Sweeps.size()) * layout.Height();
  const int head = Margin + 3 * LineHeight + study.Overview.Height + Margin;
  Canvas canvas(width, head + strips + plot.Height + Margin);
  canvas.Write(
    fmt::format("Shadow map of {0} x {0} texels, filter radius {1:g}; a texel is {2:.3g} wide and "
                "{3:.2g} pixels in the picture",
      study.Resolution, study.FilterRadius, study.TexelWidth,
      study.PixelWidth > 0 ? 1 / study.PixelWidth : 0),
    Margin, Margin, TitleSize, Ink);
  DrawOverviews(canvas, Margin + 2 * LineHeight, study);
  for (std::size_t i = 0; i < study.Sweeps.size(); ++i)
  {
    DrawStripOn(canvas, head + static_cast<int>(i) * layout.Height(), study, i);
  }
  canvas.Place(plot, Margin, head + strips);
  return canvas.Get();
}
}
