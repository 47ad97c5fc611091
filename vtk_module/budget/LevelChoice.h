// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The best level of each knob whose costs fit a limit: a knapsack problem with one choice per knob. Single steps are greedy, as
 * in Funkhouser and Séquin 1993, Adaptive Display Algorithm for Interactive Frame Rates. Greedy choices of few knobs may have a
 * third more error than the best ones, so a choice from scratch extends the Pareto front knob by knob instead, which is
 * exact for up to 1024 choices on the front.
 */
#pragma once

#include <vector>

namespace penumbra
{
/// Costs and errors of one knob's levels, from the cheapest to the best.
struct LevelValues
{
  std::vector<double> Costs;  ///< ms
  std::vector<double> Errors; ///< relMSE added to the picture
  int Most;                   ///< highest level that may be chosen
  int Least = 0;              ///< lowest one
};

/// A step of one knob to a higher level.
struct LevelStep
{
  int Knob = -1; ///< -1: there is none
  int Level = 0;
  double Cost = 0.0; ///< ms added; may be negative
  double Gain = 0.0; ///< error removed
};

/// The step that removes the most error per ms, among those that add at most room (ms) and remove at least leastGain. It skips
/// levels below the convex hull of a knob's costs and errors.
LevelStep BestStep(const std::vector<LevelValues>& knobs, const std::vector<int>& levels,
  double room, double leastGain);

/// Levels whose costs add up to at most limit (ms) with the least sum of errors; the lowest ones if nothing fits.
std::vector<int> ChooseLevels(const std::vector<LevelValues>& knobs, double limit);
}
