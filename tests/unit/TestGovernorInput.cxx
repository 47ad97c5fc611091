// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The governor of the frame budget: same decisions from the same numbers, hostile numbers, other knobs, and single choices.
 */
#include "GovernorSimulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace penumbra;

TEST(Governor, DecidesAlikeOnAllRanks)
{
  Simulator first = FourKnobs(7);
  first.Noise = 0.2;
  first.SpikeShare = 0.02;
  first.LostShare = 0.1;
  first.Latency = 2;
  first.Budget = 9.0;
  Simulator second = first;
  for (Simulator* simulator : { &first, &second })
  {
    simulator->Run(500, [&](int frame) {
      simulator->Pixels = frame / 100 % 2 == 0 ? 1.0 : 1.7;
      simulator->SceneChanged = frame == 250;
    });
  }
  EXPECT_EQ(first.Levels, second.Levels);
  EXPECT_EQ(first.Tested.PredictedTotal(), second.Tested.PredictedTotal());
  EXPECT_GT(first.Tested.ChangeCount(), 2);
}

TEST(Governor, SurvivesHostileNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Simulator simulator = FourKnobs(3);
  simulator.Run(100);
  Governor& governor = simulator.Tested;
  const double before = governor.PredictedTotal();
  const long long frame = governor.Frame();
  governor.Choose(simulator.Knobs, { 16.0, 1.0, false });
  for (const double bad : { nan, infinity, -infinity, -1.0 })
  {
    governor.Measure({ frame + 1, bad, { 1.0, 1.0, 1.0, 1.0 } });
    governor.Measure({ frame + 1, 9.0, { 1.0, bad, 1.0, 1.0 } });
  }
  governor.Measure({ frame + 1, 9.0, { 1.0 } });
  governor.Measure({ frame + 2, 900.0, { 1.0, 1.0, 1.0, 1.0 } });
  governor.Measure({ frame - 40, 900.0, { 1.0, 1.0, 1.0, 1.0 } });
  governor.Measure({ -5, 900.0, { 1.0, 1.0, 1.0, 1.0 } });
  EXPECT_EQ(governor.PredictedTotal(), before);

  const std::vector<int> lowest(4, 0);
  for (const double budget : { 1e9, infinity })
  {
    simulator.Budget = budget;
    simulator.Run(200);
    EXPECT_EQ(simulator.Levels.back(), (std::vector<int>{ 3, 2, 3, 2 }));
  }
  for (const double budget : { 1e-9, 0.0, -1.0, nan })
  {
    simulator.Budget = budget;
    simulator.Run(10);
    EXPECT_EQ(simulator.Levels.back(), lowest);
  }
  for (const double pixels : { 0.0, -1.0, nan, infinity })
  {
    EXPECT_EQ(governor.Choose(simulator.Knobs, { 16.0, pixels, false }).size(), 4U);
    EXPECT_TRUE(std::isfinite(governor.PredictedTotal()));
  }
  EXPECT_TRUE(governor.Choose({}, { 16.0, 1.0, false }).empty());
  governor.Measure({ governor.Frame(), 20.0, {} });
  const Knob one{ "one", true, { { 1.0, 0.0 } } };
  const Knob none{ "none", true, {} };
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_EQ(governor.Choose({ one, none }, { 16.0, 1.0, true }), std::vector<int>(2, 0));
    governor.Measure({ governor.Frame(), 20.0, { 3.0, 0.0 } });
  }
  EXPECT_TRUE(governor.FloorExceedsBudget());
}

TEST(Governor, KeepsWhatItKnowsOfOtherKnobs)
{
  Simulator simulator = FourKnobs(5);
  simulator.Budget = 30.0;
  simulator.Run(100);
  simulator.Knobs.erase(simulator.Knobs.begin());
  simulator.Costs.erase(simulator.Costs.begin());
  simulator.Step();
  EXPECT_EQ(simulator.Levels.back(), (std::vector<int>{ 2, 3, 2 }));
  simulator.Knobs.push_back({ "fog", true, { { 0.0, 0.2 }, { 1.0, 0.0 } } });
  simulator.Costs.push_back(
    { 0.0, 4.0 }); // off at its lowest level: its cost is unknown until it is tried
  simulator.Step();
  EXPECT_EQ(simulator.Levels.back(), (std::vector<int>{ 2, 3, 2, 0 }));
  simulator.Run(100);
  EXPECT_EQ(simulator.Levels.back(), (std::vector<int>{ 2, 3, 2, 1 }));
  EXPECT_NEAR(simulator.Tested.Predicted(3, 1), 4.0, 1e-6);
}

// A technique goes while the next one's level is probed, and the window changes before the governor has begun again.
TEST(Governor, ForgetsAProbeOfOtherKnobs)
{
  for (int frame = 4; frame < 20; ++frame)
  {
    Simulator simulator = FourKnobs(1);
    simulator.Budget = 9.0;
    simulator.Run(frame);
    simulator.Knobs.erase(simulator.Knobs.begin(), simulator.Knobs.begin() + 2);
    simulator.Costs.erase(simulator.Costs.begin(), simulator.Costs.begin() + 2);
    simulator.Step();
    const std::vector<int> levels = simulator.Levels.back();
    simulator.Pixels = 0.5;
    simulator.Step();
    EXPECT_EQ(simulator.Levels.back(), levels) << frame;
  }
}

TEST(Governor, ChoosesLikeBruteForce)
{
  // The first knob removes the same error for half the cost.
  EXPECT_EQ(
    ChooseLevels({ { { 1.0, 2.0 }, { 0.5, 0.0 }, 1 }, { { 1.0, 3.0 }, { 0.5, 0.0 }, 1 } }, 4.0),
    (std::vector<int>{ 1, 0 }));
  Random random{ 11 };
  double worst = 1.0;
  for (int instance = 0; instance < 2000; ++instance)
  {
    std::vector<LevelValues> knobs(4);
    double limit = 0.0;
    for (LevelValues& knob : knobs)
    {
      double cost = 0.0;
      double error = 0.0;
      for (int level = 0; level < 4; ++level)
      {
        cost += random.Within(0.1, 2.0);
        knob.Costs.push_back(cost);
        knob.Errors.insert(knob.Errors.begin(), error);
        error += random.Within(0.01, 0.2) * (1.0 + error);
      }
      knob.Most = 3;
      limit += knob.Costs[0] + random.Within(0.0, 0.8) * (cost - knob.Costs[0]);
    }
    double least = 1e9;
    for (int code = 0; code < 256; ++code)
    {
      double cost = 0.0;
      double error = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        cost += knobs[i].Costs[code >> 2 * i & 3];
        error += knobs[i].Errors[code >> 2 * i & 3];
      }
      least = cost <= limit ? std::min(least, error) : least;
    }
    const std::vector<int> chosen = ChooseLevels(knobs, limit);
    double error = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      error += knobs[i].Errors[chosen[i]];
    }
    worst = std::max(worst, error / least);
  }
  EXPECT_LE(worst, 1.15);
}
