// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The governor of the frame budget under made-up loads: constant, noisy, drifting, jumping, late and mispredicted ones.
 */
#include "GovernorSimulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

using namespace penumbra;

namespace
{
// All seeds and budgets between the floor and the most.
template <typename Check>
void ForLoads(Check check)
{
  for (int seed = 1; seed <= 12; ++seed)
  {
    for (const double budget : { 5.5, 5.9, 6.3, 7.0, 8.1, 9.0, 10.4, 12.0, 14.0, 18.0 })
    {
      Simulator simulator = FourKnobs(static_cast<std::uint64_t>(seed));
      simulator.Budget = budget;
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", budget " << budget);
      check(simulator);
    }
  }
}

// grace: frames more to settle.
void ExpectSteady(const Simulator& simulator, std::size_t grace = 0)
{
  EXPECT_LE(simulator.OverShare(30 + grace, simulator.Totals.size()), 0.05);
  EXPECT_LE(simulator.ChangesIn(60 + grace, simulator.Totals.size()), 10);
  EXPECT_EQ(simulator.UndoneIn(60 + grace, simulator.Totals.size()), 0);
}

void ExpectUsed(const Simulator& simulator)
{
  const double used = simulator.TrueTotal(simulator.Levels.back()) / simulator.Budget;
  EXPECT_TRUE(used >= 0.75 || !simulator.CouldStep()) << used;
}
}

TEST(Governor, IsSteadyUnderConstantLoad)
{
  for (const double noise : { 0.0, 0.05, 0.2 })
  {
    ForLoads([&](Simulator& simulator) {
      simulator.Noise = noise;
      if (simulator.Budget < 4.9 / 0.84 && noise > 0.1)
      {
        return; // the lowest levels alone exceed it in more than 5 % of frames
      }
      simulator.Run(1060);
      ExpectSteady(simulator);
      if (noise <= 0.05)
      {
        ExpectUsed(simulator);
      }
    });
  }
}

// A real machine: quiet for 350 frames, then another program takes its time for 50, in which every third frame takes 1.2 to 1.5
// times as long. Levels may follow that, but not with every burst.
TEST(Governor, KeepsABudgetUnderARecordedLoad)
{
  int most = 0;
  double worst = 0.0;
  double used = 0.0; // mean share of the budget, or of the 15 ms that the highest levels take
  ForLoads([&](Simulator& simulator) {
    simulator.Recorded = 1 + 31 * (simulator.Numbers.State % 13);
    simulator.Budget =
      std::max(simulator.Budget, 6.3); // the lowest levels fit it with the usual fluctuation
    simulator.Run(1060);
    worst = std::max(worst, simulator.OverShare(30, 1060));
    most = std::max(most, simulator.ChangesIn(60, 1060));
    EXPECT_LE(simulator.OverShare(30, 1060), 0.05);
    EXPECT_LE(simulator.ChangesIn(60, 1060), 20);
    used += simulator.TrueTotal(simulator.Levels.back()) / std::min(simulator.Budget, 15.0) / 120.0;
  });
  std::printf(
    "recorded load: at most %.1f %% over the budget, %d changes in 1000 frames, %.0f %% used\n",
    100.0 * worst, most, 100.0 * used);
  EXPECT_GE(used, 0.6);
}

TEST(Governor, IgnoresSpikes)
{
  ForLoads([](Simulator& simulator) {
    simulator.Noise = 0.05;
    Simulator without = simulator;
    without.Run(1060);
    simulator.SpikeShare = 0.02;
    simulator.Run(1060);
    EXPECT_EQ(simulator.FallsIn(30, 1060), 0);
    EXPECT_LE(simulator.ChangesIn(60, 1060), without.ChangesIn(60, 1060) + 1);
    ExpectUsed(simulator);
  });
}

TEST(Governor, FollowsDrift)
{
  ForLoads([](Simulator& simulator) {
    simulator.Noise = 0.05;
    simulator.Budget = std::max(simulator.Budget, 7.5); // the floor grows to 6.7 ms
    simulator.Run(900, [&](int frame) {
      simulator.Rest = 3.0 * (1.0 + 0.6 * std::clamp((frame - 200) / 300.0, 0.0, 1.0));
    });
    EXPECT_LE(simulator.OverShare(200, 500), 0.05);
    EXPECT_LE(simulator.OverShare(500, 900), 0.05);
  });
}

// A heavier scene from frame 300 to 600: global illumination costs five times as much, the floor twice as much.
namespace
{
void RunJump(Simulator& simulator)
{
  const Simulator light = simulator;
  simulator.Run(900, [&](int frame) {
    simulator.SceneChanged = frame == 300 || frame == 600;
    const bool isHeavy = frame >= 300 && frame < 600;
    simulator.Rest = (isHeavy ? 2.0 : 1.0) * light.Rest;
    for (std::size_t level = 0; level < light.Costs[0].size(); ++level)
    {
      simulator.Costs[0][level] = (isHeavy ? 5.0 : 1.0) * light.Costs[0][level];
    }
  });
}

void ExpectRecovery(const Simulator& simulator, std::size_t grace = 0)
{
  EXPECT_EQ(simulator.OverShare(310 + grace, 600, 1.5), 0.0);
  EXPECT_LE(simulator.OverShare(330 + grace, 600), 0.05);
  EXPECT_EQ(simulator.OverShare(600, 900, 1.5), 0.0);
  EXPECT_LE(simulator.OverShare(630, 900), 0.05);
  EXPECT_LT(simulator.Error(simulator.Levels[899]), simulator.Error(simulator.Levels[599]));
  if (simulator.Noise <= 0.05)
  {
    ExpectUsed(simulator);
  }
}
}

TEST(Governor, SurvivesJumps)
{
  for (const double noise : { 0.0, 0.05, 0.1 })
  {
    ForLoads([&](Simulator& simulator) {
      simulator.Noise = noise;
      simulator.Budget += 7.0; // the floor of the heavy scene takes 10.3 ms
      RunJump(simulator);
      ExpectRecovery(simulator);
    });
  }
}

TEST(Governor, PredictsLargerPictures)
{
  for (const double noise : { 0.0, 0.05, 0.1 })
  {
    ForLoads([&](Simulator& simulator) {
      simulator.Noise = noise;
      simulator.Budget += 5.0; // the floor takes 9.2 ms at twice the size
      simulator.Run(600, [&](int frame) { simulator.Pixels = frame < 300 ? 1.0 : 2.0; });
      EXPECT_LE(simulator.TrueTotal(simulator.Levels[300]), simulator.Budget);
      EXPECT_LE(simulator.Totals[300], simulator.Budget * (1.0 + noise));
      EXPECT_LE(simulator.OverShare(300, 600), 0.05);
    });
  }
}

TEST(Governor, CopesWithLateAndLostMeasurements)
{
  for (const double noise : { 0.0, 0.05, 0.2 })
  {
    ForLoads([&](Simulator& simulator) {
      simulator.Noise = noise;
      simulator.Latency = 3;
      simulator.LostShare = 0.2;
      Simulator jumping = simulator;
      if (simulator.Budget > 4.9 / 0.84 || noise < 0.1)
      {
        simulator.Run(1060);
        ExpectSteady(simulator, 4);
      }
      jumping.Budget += noise > 0.1 ? 8.0 : 7.0;
      RunJump(jumping);
      ExpectRecovery(jumping, 4);
    });
  }
}

TEST(Governor, TellsThatTheFloorIsTooHigh)
{
  Simulator simulator = FourKnobs(1);
  simulator.Noise = 0.1;
  simulator.Budget = 9.0;
  simulator.Run(200);
  EXPECT_FALSE(simulator.Tested.FloorExceedsBudget());
  simulator.Rest = 9.0;
  simulator.Run(29);
  EXPECT_FALSE(simulator.Tested.FloorExceedsBudget());
  simulator.Run(21);
  for (int i = 0; i < 200; ++i)
  {
    simulator.Step();
    EXPECT_TRUE(simulator.Tested.FloorExceedsBudget());
    EXPECT_EQ(simulator.Levels.back(), std::vector<int>(4, 0));
  }
  EXPECT_NEAR(simulator.Tested.Floor(), 10.9, 1.5);
  simulator.Rest = 3.0;
  simulator.Run(30);
  EXPECT_FALSE(simulator.Tested.FloorExceedsBudget());
  simulator.Run(200);
  EXPECT_GT(simulator.TrueTotal(simulator.Levels.back()), 0.7 * simulator.Budget);
}

TEST(Governor, LearnsWrongPriors)
{
  // Costs over work as promised: too steep or too flat by three times from end to end, by steps, and at random.
  const std::vector<std::vector<double>> distortions = { { 1.0, 1.44, 2.08, 3.0 },
    { 1.0, 0.7, 0.48, 0.34 }, { 1.0, 3.0, 3.0, 3.0 }, { 1.0, 0.55, 0.4, 0.34 },
    { 1.0, 1.0, 3.0, 3.0 }, { 1.0, 1.0, 1.0, 3.0 } };
  for (const double noise : { 0.0, 0.05 })
  {
    ForLoads([&](Simulator& simulator) {
      simulator.Noise = noise;
      for (std::vector<double>& costs : simulator.Costs)
      {
        const std::size_t which = static_cast<std::size_t>(simulator.Numbers.Next() * 6.0);
        for (std::size_t level = 1; level < costs.size(); ++level)
        {
          costs[level] =
            std::max(costs[level] * distortions[which][level], 1.05 * costs[level - 1]);
        }
      }
      simulator.Run(1060);
      ExpectSteady(simulator);
      ExpectUsed(simulator);
    });
  }
}

TEST(Governor, ProbesTheNextLevelsAfterAStart)
{
  int probed = 0;
  ForLoads([&](Simulator& simulator) {
    for (std::vector<double>& costs : simulator.Costs)
    {
      for (std::size_t level = 1; level < costs.size(); ++level)
      {
        costs[level] *= 1.3; // dearer than the work promises
      }
    }
    simulator.Run(30);
    const std::vector<int>& levels = simulator.Levels.back();
    const auto tried = [&](std::size_t knob) {
      return std::any_of(simulator.Levels.begin(), simulator.Levels.end(),
        [&](const std::vector<int>& then) { return then[knob] == levels[knob] + 1; });
    };
    for (std::size_t knob = 0; knob < levels.size(); ++knob)
    {
      const auto next = static_cast<std::size_t>(levels[knob]) + 1;
      if (next < simulator.Costs[knob].size() && tried(knob))
      {
        ++probed;
        EXPECT_NEAR(simulator.Tested.Predicted(static_cast<int>(knob), static_cast<int>(next)),
          simulator.Costs[knob][next], 0.05 * simulator.Costs[knob][next]);
      }
    }
    EXPECT_LE(simulator.OverShare(5, 30, 1.5), 0.0);
    EXPECT_LE(simulator.OverShare(3, 30), 0.45); // a first choice that was too dear is mended first
  });
  EXPECT_GE(probed, 240); // two knobs in each of 120 runs
}

TEST(Governor, AnswersALargerWindowWhileItProbes)
{
  ForLoads([](Simulator& simulator) {
    simulator.Budget += 5.0; // the floor takes 9.2 ms at twice the size
    simulator.Run(60, [&](int frame) { simulator.Pixels = frame < 8 ? 1.0 : 2.0; });
    EXPECT_LE(simulator.TrueTotal(simulator.Levels[8]), simulator.Budget);
  });
}

// After a heavy scene has become lighter, the error is near that of the best choice for a share of the budget, which single steps
// from what was good before do not reach.
TEST(Governor, EndsNearTheBestChoice)
{
  double sum = 0.0;
  double worst = 0.0;
  int count = 0;
  ForLoads([&](Simulator& simulator) {
    if (simulator.Budget < 7.0 || simulator.Budget > 14.0)
    {
      return; // all lowest, or all highest
    }
    simulator.Noise = 0.05;
    simulator.Run(1500, [&](int frame) {
      simulator.Rest = 3.0 * (1.8 - 0.8 * std::clamp((frame - 300) / 100.0, 0.0, 1.0));
    });
    std::vector<LevelValues> knobs;
    for (std::size_t i = 0; i < simulator.Knobs.size(); ++i)
    {
      knobs.push_back({ simulator.Costs[i], {}, static_cast<int>(simulator.Costs[i].size()) - 1 });
      for (const KnobLevel& level : simulator.Knobs[i].Levels)
      {
        knobs.back().Errors.push_back(level.Error);
      }
    }
    const std::vector<int> best = ChooseLevels(knobs, 0.85 * simulator.Budget - simulator.Rest);
    const double ratio = simulator.Error(simulator.Levels.back()) / simulator.Error(best);
    sum += ratio;
    worst = std::max(worst, ratio);
    ++count;
  });
  std::printf("error / that of the best choice: mean %.2f, worst %.2f\n", sum / count, worst);
  EXPECT_LE(sum / count, 0.85);
  EXPECT_LE(worst, 1.25);
}

// What was best for a heavy scene leaves no room for a single step when the scene has become lighter.
TEST(Governor, ExchangesLevelsWhereNoSingleStepFits)
{
  Simulator simulator;
  simulator.Budget = 10.0;
  simulator.Knobs = { { "dear", false, { { 1, 0.5 }, { 5, 0.0 } } },
    { "cheap", false, { { 1, 0.2 }, { 3, 0.0 } } } };
  simulator.Costs = { { 1.0, 5.0 }, { 1.0, 3.0 } };
  simulator.Run(900,
    [&](int frame) { simulator.Rest = 4.4 - 1.4 * std::clamp((frame - 100) / 200.0, 0.0, 1.0); });
  EXPECT_EQ(simulator.Levels[99], (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(simulator.Levels.back(), (std::vector<int>{ 1, 0 }));
  EXPECT_EQ(simulator.OverShare(30, 900), 0.0);
}

// Refining frames may take longer than the budget, but must keep within that time as surely.
TEST(Governor, KeepsTheMarginForAnotherTime)
{
  ForLoads([](Simulator& simulator) {
    simulator.Noise = 0.1;
    simulator.Run(400);
    Simulator without = simulator;
    for (const double time : { 7.0, 8.0, 10.0, 13.0 })
    {
      const std::vector<int> levels = simulator.Tested.LevelsFor(time);
      const double target = simulator.Tested.TargetFor(time);
      EXPECT_LE(simulator.Tested.PredictedTotal(levels), target);
      EXPECT_LE(simulator.Tested.PredictedTotal(levels), 0.95 * time);
      EXPECT_LE(simulator.TrueTotal(levels), time);
      for (std::size_t knob = 0; knob < levels.size(); ++knob)
      {
        std::vector<int> more = levels;
        ++more[knob];
        EXPECT_TRUE(more[knob] == static_cast<int>(simulator.Costs[knob].size()) ||
          simulator.Tested.PredictedTotal(more) > target);
      }
    }
    simulator.Run(100);
    without.Run(100);
    EXPECT_EQ(simulator.Levels, without.Levels);
  });
}
