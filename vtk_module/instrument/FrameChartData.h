// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Data of a chart of a frame's cost, read from the statistics of a pass.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace penumbra
{
/// Approach by which a technique keeps a frame cheap. Rest: everything outside of techniques, such as VTK's own drawing.
enum class Approach
{
  Precompute,
  Approximate,
  Amortise,
  Rest
};
constexpr int ApproachCount = 4;

/// The name in the statistics: "precompute", "approximate", "amortise" or "rest".
const char* ApproachName(Approach approach);

struct ChartPass
{
  std::string Name;
  std::string Technique;
  Approach Payment = Approach::Rest;
  double Milliseconds = 0.0;
};

struct ChartLevel
{
  std::string Name;
  double Milliseconds = 0.0;
  double Error = 0.0; ///< 0 if exact
};

struct ChartKnob
{
  std::string Technique;
  Approach Payment = Approach::Rest;
  int Level = -1; ///< in force; -1 if none
  std::vector<ChartLevel> Levels;
};

struct FrameChartData
{
  std::vector<ChartPass> Passes;
  /// The complete frame; 0 if unknown. What exceeds the passes counts as rest.
  double Frame = 0.0;
  bool HasBudget = false;
  double Budget = 0.0;
  double Floor = 0.0;
  std::string State;
  std::vector<ChartKnob> Knobs;
  /// Milliseconds by approach, the oldest frame first.
  std::vector<std::array<double, ApproachCount>> History;
};

/// A duration or error as it can be drawn: 0 for a number that is negative or not finite, and at most 1e12.
double Drawable(double number);

/// Reads vtkGIPass::GetStatistics(). Returns false with a sentence in error, and leaves data unchanged, if the text is no
/// such JSON.
bool ReadFrameChart(const char* json, FrameChartData& data, std::string& error);
}
