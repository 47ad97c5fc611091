// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "budget/LevelChoice.h"

#include <algorithm>
#include <cstddef>

namespace penumbra
{
namespace
{
// A choice of levels of the first few knobs.
struct Partial
{
  double Cost;
  double Error;
  int Before; ///< index of the choice without the last knob
  int Level;  ///< of the last knob
};

// Drops choices that cost more than another without less error. Of too many, every other one.
void Prune(std::vector<Partial>& choices)
{
  constexpr std::size_t most = 1024;
  std::stable_sort(choices.begin(), choices.end(), [](const Partial& a, const Partial& b) {
    return a.Cost < b.Cost || (a.Cost == b.Cost && a.Error < b.Error);
  });
  std::vector<Partial> kept;
  for (const Partial& choice : choices)
  {
    if (kept.empty() || choice.Error < kept.back().Error)
    {
      kept.push_back(choice);
    }
  }
  while (kept.size() > most)
  {
    for (std::size_t i = 1; 2 * i < kept.size(); ++i)
    {
      kept[i] = kept[2 * i];
    }
    kept.resize((kept.size() + 1) / 2);
  }
  choices = kept;
}
}

LevelStep BestStep(const std::vector<LevelValues>& knobs, const std::vector<int>& levels,
  double room, double leastGain)
{
  // Free steps come first, the most helpful of them in front.
  constexpr double leastCost = 1e-6;
  LevelStep best;
  double bestRate = 0.0;
  for (int knob = 0; knob < static_cast<int>(knobs.size()); ++knob)
  {
    const LevelValues& values = knobs[knob];
    for (int level = levels[knob] + 1; level <= values.Most; ++level)
    {
      const double cost = values.Costs[level] - values.Costs[levels[knob]];
      const double gain = values.Errors[levels[knob]] - values.Errors[level];
      const double rate = gain / std::max(cost, leastCost);
      if (cost <= room && gain >= leastGain && rate > bestRate)
      {
        best = { knob, level, cost, gain };
        bestRate = rate;
      }
    }
  }
  return best;
}

std::vector<int> ChooseLevels(const std::vector<LevelValues>& knobs, double limit)
{
  std::vector<int> levels;
  const auto cheapest = [](const LevelValues& knob) {
    return *std::min_element(knob.Costs.begin() + knob.Least, knob.Costs.begin() + knob.Most + 1);
  };
  double lowest = 0.0; // of the knobs that are not chosen yet
  for (const LevelValues& knob : knobs)
  {
    levels.push_back(knob.Least);
    lowest += cheapest(knob);
  }
  limit = std::max(limit, lowest * (1.0 + 1e-9)); // levels that cost nothing are chosen in any case
  std::vector<std::vector<Partial>> fronts = { { { 0.0, 0.0, 0, 0 } } };
  for (const LevelValues& knob : knobs)
  {
    lowest -= cheapest(knob);
    std::vector<Partial> front;
    for (std::size_t i = 0; i < fronts.back().size(); ++i)
    {
      const Partial& before = fronts.back()[i];
      for (int level = knob.Least; level <= knob.Most; ++level)
      {
        const double cost = before.Cost + knob.Costs[level];
        if (cost + lowest <= limit)
        {
          front.push_back({ cost, before.Error + knob.Errors[level], static_cast<int>(i), level });
        }
      }
    }
    if (front.empty())
    {
      return levels; // costs that are no numbers
    }
    Prune(front);
    fronts.push_back(front);
  }
  std::size_t at = fronts.back().size() - 1; // the most expensive has the least error
  for (std::size_t knob = knobs.size(); knob > 0; --knob)
  {
    const Partial& choice = fronts[knob][at];
    levels[knob - 1] = choice.Level;
    at = static_cast<std::size_t>(choice.Before);
  }
  return levels;
}
}
