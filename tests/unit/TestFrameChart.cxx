// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The chart of a frame's cost: what is drawn where, for usual and for hostile statistics.
#include "instrument/FrameChartLayout.h"
#include "instrument/FrameChartSvg.h"

#include <gtest/gtest.h>
#include <vtkGIFrameChart.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

using namespace penumbra;

namespace
{
ChartKnob MakeKnob(int index)
{
  ChartKnob knob;
  knob.Technique = "technique_" + std::to_string(index);
  knob.Payment = static_cast<Approach>(index % 3);
  knob.Level = index % 3;
  knob.Levels = { { "low", 0.5 + index, 0.2 }, { "middle", 1.0 + index, 0.03 },
    { "exact", 4.0, 0.0 } };
  return knob;
}

FrameChartData MakeData(int passes, double milliseconds, int knobs, int history)
{
  FrameChartData data;
  for (int i = 0; i < passes; ++i)
  {
    data.Passes.push_back(
      { "pass-" + std::to_string(i), i % 5 ? "technique_" + std::to_string(i % 7) : "",
        static_cast<Approach>(i % ApproachCount), milliseconds * (1 + i % 3) });
  }
  data.HasBudget = true;
  data.Budget = 16.7;
  data.Floor = 6.1;
  data.State = "moving";
  for (int i = 0; i < knobs; ++i)
  {
    data.Knobs.push_back(MakeKnob(i));
  }
  for (int i = 0; i < history; ++i)
  {
    data.History.push_back({ 1.0, 5.0, 4.0 + i % 13, 4.0 });
  }
  return data;
}

std::vector<ChartShape> LayOut(const FrameChartData& data, int width, int height)
{
  ChartStyle style;
  style.Width = width;
  style.Height = height;
  return LayOutFrameChart(data, style);
}

std::vector<ChartShape> Select(const std::vector<ChartShape>& shapes, ChartRole role)
{
  std::vector<ChartShape> found;
  std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(found),
    [role](const ChartShape& shape) { return shape.Role == role; });
  return found;
}

std::vector<ChartShape> Texts(const std::vector<ChartShape>& shapes)
{
  std::vector<ChartShape> found;
  std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(found),
    [](const ChartShape& shape) { return shape.Kind == ChartKind::Text; });
  return found;
}

bool HasText(const std::vector<ChartShape>& shapes, const std::string& part)
{
  const auto texts = Texts(shapes);
  return std::any_of(texts.begin(), texts.end(),
    [&part](const ChartShape& shape) { return shape.Text.find(part) != std::string::npos; });
}

double SumOfValues(const std::vector<ChartShape>& shapes)
{
  double sum = 0.0;
  for (const ChartShape& shape : shapes)
  {
    sum += shape.Value;
  }
  return sum;
}

double SumOfPasses(const FrameChartData& data)
{
  double sum = 0.0;
  for (const ChartPass& pass : data.Passes)
  {
    sum += Drawable(pass.Milliseconds);
  }
  return sum;
}

/// Some space for rounding, in pixels.
constexpr double Rounding = 1e-6;

void ExpectApart(const std::vector<ChartShape>& shapes)
{
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    ChartBox box = shapes[i].Box;
    box.Left += Rounding;
    box.Right -= Rounding;
    box.Bottom += Rounding;
    box.Top -= Rounding;
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_FALSE(box.Overlaps(shapes[j].Box)) << shapes[i].Text << " on " << shapes[j].Text;
    }
  }
}

void ExpectSound(const std::vector<ChartShape>& shapes, int width, int height)
{
  for (const ChartShape& shape : shapes)
  {
    const ChartBox& box = shape.Box;
    for (const double number :
      { box.Left, box.Bottom, box.Right, box.Top, shape.Size, shape.Value })
    {
      ASSERT_TRUE(std::isfinite(number));
    }
    EXPECT_GE(std::min(box.Left, box.Right), -Rounding);
    EXPECT_LE(std::max(box.Left, box.Right), width + Rounding);
    EXPECT_GE(std::min(box.Bottom, box.Top), -Rounding) << shape.Text;
    EXPECT_LE(std::max(box.Bottom, box.Top), height + Rounding) << shape.Text;
  }
  ExpectApart(Texts(shapes));
  const auto bars = Select(shapes, ChartRole::Bar);
  ExpectApart(bars);
  for (std::size_t i = 0; i < bars.size(); ++i)
  {
    EXPECT_GE(bars[i].Box.Width(), 2.0 - Rounding);
    if (i > 0)
    {
      EXPECT_NEAR(bars[i].Box.Left, bars[i - 1].Box.Right, Rounding);
    }
  }
  const auto columns = Select(shapes, ChartRole::Column);
  for (const ChartShape& column : columns)
  {
    EXPECT_GE(column.Box.Width(), 1.0 - Rounding);
  }
  if (columns.size() < 500)
  {
    ExpectApart(columns);
  }
}

void ExpectSoundAtAnySize(const FrameChartData& data)
{
  for (const auto& size : { std::pair{ 640, 200 }, std::pair{ 1200, 500 }, std::pair{ 300, 120 },
         std::pair{ 90, 900 }, std::pair{ 4000, 60 }, std::pair{ 1, 1 } })
  {
    SCOPED_TRACE(std::to_string(size.first) + " x " + std::to_string(size.second));
    const auto shapes = LayOut(data, size.first, size.second);
    ExpectSound(shapes, size.first, size.second);
    const auto bars = Select(shapes, ChartRole::Bar);
    if (!bars.empty())
    {
      const double expected = std::max(SumOfPasses(data), Drawable(data.Frame));
      EXPECT_NEAR(SumOfValues(bars), expected, 1e-9 * expected);
    }
    const std::string svg = FrameChartSvg(shapes, size.first, size.second);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
  }
}

std::string Error(const char* json)
{
  FrameChartData data = MakeData(1, 1.0, 0, 0);
  std::string error;
  EXPECT_FALSE(ReadFrameChart(json, data, error));
  EXPECT_EQ(data.Passes.size(), 1U) << "the data changed";
  return error;
}
}

TEST(FrameChart, RefusesOtherTextWithASentence)
{
  for (const char* json : { "", "{", "nonsense", "[]", "3", "null", "{}", "{\"passes\": 3}",
         "{\"passes\": [{\"milliseconds\": 1e999}]}", "{\"passes\": [\"\xff\"]}" })
  {
    const std::string error = Error(json);
    ASSERT_FALSE(error.empty()) << json;
    EXPECT_EQ(error.back(), '.') << error;
  }
  EXPECT_FALSE(Error(nullptr).empty());
}

TEST(FrameChart, TakesValuesOfTheWrongTypeAsMissing)
{
  FrameChartData data;
  std::string error;
  ASSERT_TRUE(ReadFrameChart(
    R"({"passes": [3, {}, {"name": 4, "milliseconds": null}, {"milliseconds": -2, "approach": []}],
        "milliseconds": "many", "budget": {"milliseconds": {}, "knobs": [{"level": 7, "levels": [{}]}, 1],
        "history": [null, {"frame": 3}, {"frame": [], "amortise": 2}]}})",
    data, error))
    << error;
  EXPECT_EQ(data.Passes.size(), 3U);
  EXPECT_EQ(data.Knobs.size(), 1U);
  EXPECT_EQ(data.Knobs[0].Level, -1);
  ASSERT_EQ(data.History.size(), 2U);
  EXPECT_EQ(data.History[0][static_cast<int>(Approach::Rest)], 3.0);
  ExpectSoundAtAnySize(data);
}

TEST(FrameChart, TheItemKeepsItsChartIfTheTextIsBad)
{
  vtkNew<vtkGIFrameChart> chart;
  EXPECT_TRUE(chart->SetStatistics(R"({"passes": []})"));
  EXPECT_STREQ(chart->GetLastError(), "");
  const auto time = chart->GetMTime();
  EXPECT_FALSE(chart->SetStatistics("{"));
  EXPECT_STRNE(chart->GetLastError(), "");
  EXPECT_FALSE(chart->SetStatistics(nullptr));
  EXPECT_EQ(chart->GetMTime(), time);
}

TEST(FrameChart, TheBarIsAsLongAsTheFrame)
{
  FrameChartData data;
  std::string error;
  ASSERT_TRUE(ReadFrameChart(
    R"({"passes": [{"name": "trace", "milliseconds": 4, "technique": "ddgi", "approach": "amortise"},
        {"name": "capture", "milliseconds": 2}, {"name": "blend", "milliseconds": 1, "technique": "ddgi",
        "approach": "amortise"}, {"name": "look-up", "milliseconds": 1, "approach": "precompute"}],
        "budget": {"milliseconds": 20, "frame": 10}})",
    data, error));
  const auto shapes = LayOut(data, 1200, 500);
  const auto bars = Select(shapes, ChartRole::Bar);
  // By approach: look-up; trace and blend; capture and what the passes leave of the frame.
  ASSERT_EQ(bars.size(), 5U);
  const double values[] = { 1.0, 4.0, 1.0, 2.0, 2.0 };
  const double pixels = bars[1].Box.Width() / 4.0;
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(bars[i].Value, values[i], 1e-12);
    EXPECT_NEAR(bars[i].Box.Width(), values[i] * pixels, 1e-9);
  }
  // The budget is at its place on the same axis.
  const auto budget = Select(shapes, ChartRole::Budget);
  ASSERT_FALSE(budget.empty());
  EXPECT_NEAR(budget[0].Box.Left, bars[0].Box.Left + 20.0 * pixels, 1e-9);
  for (const char* text :
    { "ddgi", "20.0 ms", "precompute 1.0", "amortise 5.0", "rest 4.0", "10.0 ms of 20.0" })
  {
    EXPECT_TRUE(HasText(shapes, text)) << text;
  }
}

TEST(FrameChart, ShortPassesShareABar)
{
  FrameChartData data = MakeData(0, 0.0, 0, 0);
  data.Passes.push_back({ "long", "a", Approach::Approximate, 15.0 });
  for (int i = 0; i < 40; ++i)
  {
    data.Passes.push_back({ "short", "b", Approach::Amortise, 1e-5 });
  }
  const auto bars = Select(LayOut(data, 640, 200), ChartRole::Bar);
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_NEAR(bars[1].Box.Width(), 2.0, 1e-9);
  EXPECT_NE(bars[1].Text.find("40 short passes"), std::string::npos);
}

TEST(FrameChart, WithoutABudgetThereIsOnlyTheBar)
{
  FrameChartData data = MakeData(6, 1.0, 4, 40);
  data.HasBudget = false;
  const auto shapes = LayOut(data, 1200, 500);
  EXPECT_FALSE(Select(shapes, ChartRole::Bar).empty());
  for (const ChartRole role :
    { ChartRole::Column, ChartRole::Level, ChartRole::Force, ChartRole::Budget })
  {
    EXPECT_TRUE(Select(shapes, role).empty());
  }
}

TEST(FrameChart, MarksFramesOverBudget)
{
  FrameChartData data = MakeData(4, 1.0, 0, 0);
  data.Budget = 10.0;
  data.History = { { 1.0, 2.0, 3.0, 1.0 }, { 1.0, 2.0, 3.0, 5.0 }, { 1.0, 2.0, 3.0, 1e9 },
    { 10.0, 0.0, 0.0, 0.0 } };
  const auto shapes = LayOut(data, 1200, 500);
  EXPECT_EQ(Select(shapes, ChartRole::Over).size(), 2U);
  EXPECT_TRUE(HasText(shapes, "2 over budget"));
  ExpectSound(shapes, 1200, 500);
}

TEST(FrameChart, PlacesKnobsByCostAndError)
{
  FrameChartData data = MakeData(4, 1.0, 1, 1);
  data.Knobs[0].Level = 2;
  const auto shapes = LayOut(data, 1200, 500);
  const auto force = Select(shapes, ChartRole::Force);
  ASSERT_EQ(force.size(), 1U);
  EXPECT_TRUE(HasText(shapes, "technique 0 exact"));
  // A line between each two levels, and two discs for each.
  const auto levels = Select(shapes, ChartRole::Level);
  ASSERT_EQ(levels.size(), 2U + 6U);
  const auto y = [](const ChartShape& shape) { return 0.5 * (shape.Box.Bottom + shape.Box.Top); };
  EXPECT_GT(y(levels[2]), y(levels[4]));
  EXPECT_GT(y(levels[4]), y(levels[6]));
  EXPECT_NEAR(y(levels[6]), y(force[0]), 1e-9);
}

TEST(FrameChart, StaysSoundWithHostileNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double milliseconds : { 0.0, 1e-300, 1e-6, 1.0, 1e9, 1e300, -1.0, nan, infinity })
  {
    SCOPED_TRACE(milliseconds);
    FrameChartData data = MakeData(9, milliseconds, 2, 3);
    ExpectSoundAtAnySize(data);
    data.Budget = milliseconds;
    data.Floor = milliseconds;
    data.Frame = milliseconds;
    data.History.push_back({ milliseconds, milliseconds, milliseconds, milliseconds });
    for (ChartLevel& level : data.Knobs[0].Levels)
    {
      level.Milliseconds = milliseconds;
      level.Error = milliseconds;
    }
    data.Knobs[1].Level = 99;
    ExpectSoundAtAnySize(data);
  }
}

TEST(FrameChart, StaysSoundWithManyOrFewOfEach)
{
  for (const int history : { 0, 1, 119, 120, 5000 })
  {
    SCOPED_TRACE(history);
    ExpectSoundAtAnySize(MakeData(5, 1.0, 1, history));
  }
  for (const int knobs : { 0, 1, 10, 100 })
  {
    SCOPED_TRACE(knobs);
    ExpectSoundAtAnySize(MakeData(5, 1.0, knobs, 10));
  }
  for (const int passes : { 0, 1, 200 })
  {
    SCOPED_TRACE(passes);
    ExpectSoundAtAnySize(MakeData(passes, 0.05, 1, 10));
  }
}

TEST(FrameChart, StaysSoundWithAnyNames)
{
  FrameChartData data = MakeData(8, 1.0, 3, 10);
  const std::string names[] = { "", " ", "__", std::string(3000, 'm'), "<&\">",
    "\xc3\xa9"
    "clairage" };
  for (int i = 0; i < 6; ++i)
  {
    data.Passes[i].Name = names[i];
    data.Passes[i].Technique = names[(i + 1) % 6];
    data.Knobs[i % 3].Technique = names[i];
    data.Knobs[i % 3].Levels[i % 3].Name = names[i];
  }
  data.State = names[3];
  ExpectSoundAtAnySize(data);
  const std::string svg = FrameChartSvg(LayOut(data, 1200, 500), 1200, 500);
  EXPECT_EQ(svg.find("<&"), std::string::npos);
}
