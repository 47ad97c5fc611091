// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// One frame budget for two processes that draw a picture together: with other costs, times that come at other moments, and
// frames that one of them does not draw, both choose the same levels in every frame.
#include "GovernorSimulator.h"

#include "pass/FrameBudget.h"
#include "technique/TechniqueRegistry.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <deque>
#include <map>
#include <string>

using namespace penumbra;

namespace
{
constexpr double Budget = 20.0;
constexpr double Rest = 4.0;

struct Rank
{
  FrameBudget Tested;
  FrameBudget::Techniques Techniques = CreateTechniques();
  std::map<std::string, double> Costs; ///< ms per level
  std::deque<TimedFrame> Late;
  std::size_t Latency = 0; ///< frames by which times are late
  Random Numbers{ 1 };
  long long Drawn = 0;
  double Total = 0.0; ///< ms of the last frame

  Rank(std::map<std::string, double> costs, std::size_t latency, unsigned seed)
    : Costs(std::move(costs))
    , Latency(latency)
    , Numbers{ seed }
  {
    for (auto& technique : this->Techniques)
    {
      technique->ApplyPreset("balanced");
      technique->SetTookPart(technique->GetEnabled());
    }
  }

  FrameBudget::Situation Situation() const
  {
    FrameBudget::Situation situation;
    situation.Budget = Budget;
    situation.Pixels = 1e6;
    situation.ClockTime = 16.0 * static_cast<double>(this->Drawn);
    return situation;
  }
  std::map<std::string, int> Levels() const
  {
    std::map<std::string, int> levels;
    const auto state = this->Tested.Describe();
    for (const auto& knob : state.at("knobs"))
    {
      levels[knob.at("technique")] = knob.at("level");
    }
    return levels;
  }
  void Draw()
  {
    const long long number = this->Drawn++;
    this->Tested.Begin(this->Techniques, this->Situation(), number);
    TimedFrame frame;
    frame.Number = number;
    const double noise = this->Numbers.Within(0.95, 1.05);
    for (const auto& [technique, level] : this->Levels())
    {
      const auto found = this->Costs.find(technique);
      const double cost = found == this->Costs.end() ? 0.1 : found->second;
      frame.Spans.push_back({ technique, technique, noise * cost * (level + 1) });
      frame.Milliseconds += frame.Spans.back().Milliseconds;
    }
    frame.Milliseconds += noise * Rest;
    this->Total = frame.Milliseconds;
    this->Tested.End();
    if (number % 37 == 5)
    {
      this->Tested.Ignore(number);
    }
    if (number % 41 != 7) // else it is not timed
    {
      this->Late.push_back(frame);
    }
    while (this->Late.size() > this->Latency)
    {
      this->Tested.Measure(this->Late.front());
      this->Late.pop_front();
    }
  }
};

void Share(std::vector<Rank*> ranks)
{
  std::vector<double> most;
  for (Rank* rank : ranks)
  {
    const std::vector<double> values = rank->Tested.Offer(rank->Techniques, rank->Situation());
    most.resize(values.size(), values.empty() ? 0.0 : -1e300);
    std::transform(most.begin(), most.end(), values.begin(), most.begin(),
      [](double a, double b) { return std::max(a, b); });
  }
  for (Rank* rank : ranks)
  {
    rank->Tested.Accept(rank->Techniques, most);
  }
}

Rank Occluded()
{
  return { { { "ambient-occlusion", 4.0 }, { "shadow-maps", 0.2 } }, 0, 1 };
}
Rank Shadowed()
{
  return { { { "ambient-occlusion", 0.2 }, { "shadow-maps", 3.0 } }, 3, 2 };
}
}

TEST(SharedBudget, IsSpentAlikeByTheTimesOfTheSlowest)
{
  Rank one = Occluded();
  Rank two = Shadowed();
  Rank alone = Shadowed();
  std::vector<std::map<std::string, int>> seen;
  int slow = 0;
  for (int i = 0; i < 300; ++i)
  {
    Share({ &one, &two });
    ASSERT_EQ(one.Levels(), two.Levels()) << "frame " << i;
    ASSERT_FALSE(one.Levels().empty());
    one.Draw();
    two.Draw();
    alone.Draw();
    ASSERT_EQ(one.Levels(), two.Levels()) << "frame " << i;
    if (seen.empty() || one.Levels() != seen.back())
    {
      seen.push_back(one.Levels());
    }
    slow += i >= 100 && std::max(one.Total, two.Total) > Budget ? 1 : 0;
  }
  EXPECT_GE(seen.size(), 2u) << "levels go up from the lowest";
  EXPECT_LE(slow, 10);
  EXPECT_GT(alone.Levels().at("ambient-occlusion"), two.Levels().at("ambient-occlusion"))
    << "what is cheap here is dear elsewhere";
}

TEST(SharedBudget, IsKeptWhileAProcessDrawsNothing)
{
  Rank one = Occluded();
  Rank two = Shadowed();
  for (int i = 0; i < 300; ++i)
  {
    Share({ &one, &two });
    ASSERT_EQ(one.Levels(), two.Levels()) << "frame " << i;
    one.Draw();
    if (i >= 250 || (i >= 60 && i % 80 < 40))
    {
      two.Draw();
    }
  }
}

TEST(SharedBudget, IsSharedFromTheBeginningByAProcessThatNeverDraws)
{
  Rank one = Occluded();
  Rank two = Shadowed();
  bool changed = false;
  for (auto& technique : two.Techniques)
  {
    technique->SetTookPart(false);
  }
  for (int i = 0; i < 100; ++i)
  {
    Share({ &one, &two });
    const auto before = one.Levels();
    ASSERT_EQ(before, two.Levels()) << "frame " << i;
    one.Draw();
    changed = changed ||
      std::any_of(before.begin(), before.end(), [](const auto& level) { return level.second > 0; });
  }
  EXPECT_TRUE(changed) << "its missing times keep nothing waiting";
}

TEST(SharedBudget, BeginsAgainTogether)
{
  Rank one = Occluded();
  Rank two = Shadowed();
  for (int i = 0; i < 200; ++i)
  {
    if (i == 90)
    {
      two.Tested = FrameBudget(); // as in a new context
    }
    if (i == 140)
    {
      one.Draw(); // alone
    }
    Share({ &one, &two });
    ASSERT_EQ(one.Levels(), two.Levels()) << "frame " << i;
    one.Draw();
    two.Draw();
  }
}

TEST(SharedBudget, DoesNotHoldUpAProcessThatGoesOnAlone)
{
  Rank one = Occluded();
  Rank two = Shadowed();
  for (int i = 0; i < 20; ++i)
  {
    Share({ &one, &two });
    one.Draw();
    two.Draw();
  }
  for (int i = 0; i < 100; ++i)
  {
    two.Draw();
  }
  Rank alone = Shadowed();
  for (int i = 0; i < 120; ++i)
  {
    alone.Draw();
  }
  EXPECT_EQ(two.Levels().at("ambient-occlusion"), alone.Levels().at("ambient-occlusion"));
}
