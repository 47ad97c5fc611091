// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Frames whose costs are made up, to test the governor without a GPU.
 */
#pragma once

#include "RecordedFrames.h"

#include "budget/Governor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace penumbra
{
/// A linear congruential generator (Knuth, MMIX), so that all machines replay the same frames.
struct Random
{
  std::uint64_t State;

  /// Uniform in [0, 1).
  double Next()
  {
    this->State = this->State * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(this->State >> 11) / 9007199254740992.0;
  }
  double Within(double low, double high) { return low + (high - low) * this->Next(); }
};

struct Simulator
{
  Governor Tested;
  std::vector<Knob> Knobs;
  std::vector<std::vector<double>>
    Costs;              ///< true ms by knob and level, without noise, for one pixel
  double Rest = 3.0;    ///< ms
  double Budget = 16.0; ///< ms
  double Pixels = 1.0;
  double Noise = 0.0; ///< largest relative deviation; uniform
  std::size_t Recorded =
    0; ///< instead: the frame of RecordedFrames at which to begin, from 1; 0: none
  double SpikeShare = 0.0;
  double LostShare = 0.0;
  std::size_t Latency = 0; ///< frames by which measurements are late
  Random Numbers{ 1 };
  bool SceneChanged = false; ///< for the next frame

  // What happened, by frame.
  std::vector<double> Totals;
  std::vector<std::vector<int>> Levels;
  std::vector<double> Targets;

  /// True ms of a frame, without noise.
  double TrueTotal(const std::vector<int>& levels) const
  {
    double total = this->Rest * this->Pixels;
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      total += this->Costs[i][levels[i]] * (this->Knobs[i].PerPixel ? this->Pixels : 1.0);
    }
    return total;
  }

  void Step()
  {
    const std::vector<int> levels =
      this->Tested.Choose(this->Knobs, { this->Budget, this->Pixels, this->SceneChanged });
    this->SceneChanged = false;
    this->SinceSpike += 1;
    const bool isSpike = this->Numbers.Next()<this->SpikeShare&& this->SinceSpike> 3;
    this->SinceSpike = isSpike ? 0 : this->SinceSpike;
    const double noise =
      (1.0 + this->Numbers.Within(-this->Noise, this->Noise)) * (isSpike ? 4.0 : 1.0);
    constexpr std::size_t recordedCount = sizeof(RecordedFrames) / sizeof(*RecordedFrames);
    const double factor = this->Recorded
      ? RecordedFrames[(this->Recorded + this->Totals.size()) % recordedCount]
      : noise;
    FrameCost cost{ this->Tested.Frame(), factor * this->TrueTotal(levels), {} };
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      const double pixels = this->Knobs[i].PerPixel ? this->Pixels : 1.0;
      cost.ByKnob.push_back(factor * this->Costs[i][levels[i]] * pixels);
    }
    this->Totals.push_back(cost.Total);
    this->Levels.push_back(levels);
    this->Targets.push_back(this->Tested.Target());
    this->Pending.push_back(cost);
    if (this->Pending.size() > this->Latency)
    {
      if (!(this->Numbers.Next() < this->LostShare))
      {
        this->Tested.Measure(this->Pending.front());
      }
      this->Pending.pop_front();
    }
  }

  void Run(
    int frames, const std::function<void(int)>& before = [](int) {})
  {
    for (int i = 0; i < frames; ++i)
    {
      before(static_cast<int>(this->Totals.size()));
      this->Step();
    }
  }

  /// Share of the frames in [begin, end) that took longer than factor times the budget.
  double OverShare(std::size_t begin, std::size_t end, double factor = 1.0) const
  {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      count += this->Totals[i] > factor * this->Budget * (1.0 + 1e-12) ? 1 : 0;
    }
    return static_cast<double>(count) / static_cast<double>(end - begin);
  }

  int ChangesIn(std::size_t begin, std::size_t end) const
  {
    int count = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      count += this->Levels[i] != this->Levels[i - 1] ? 1 : 0;
    }
    return count;
  }

  /// Number of times that levels with a larger error were chosen in [begin, end).
  int FallsIn(std::size_t begin, std::size_t end) const
  {
    int count = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      count += this->Error(this->Levels[i]) > this->Error(this->Levels[i - 1]) ? 1 : 0;
    }
    return count;
  }

  /// Changes of a knob in [begin, end) that return to the level before its previous change, less than 60 frames after it.
  int UndoneIn(std::size_t begin, std::size_t end) const
  {
    int count = 0;
    for (std::size_t knob = 0; knob < this->Knobs.size(); ++knob)
    {
      std::size_t last = 0;
      int before = -1;
      for (std::size_t i = 1; i < end; ++i)
      {
        const int old = this->Levels[i - 1][knob];
        if (this->Levels[i][knob] != old)
        {
          const bool isUndone = this->Levels[i][knob] == before && i - last < 60 && last > 0;
          count += isUndone && i >= begin ? 1 : 0;
          before = old;
          last = i;
        }
      }
    }
    return count;
  }

  double Error(const std::vector<int>& levels) const
  {
    double error = 0.0;
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      error += this->Knobs[i].Levels[levels[i]].Error;
    }
    return error;
  }

  /// Whether some single step of a knob would fit the target by its true costs, and be worth it.
  bool CouldStep() const
  {
    std::vector<int> levels = this->Levels.back();
    const double error = this->Error(levels);
    bool could = false;
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      const int level = levels[i];
      for (levels[i] = level + 1; levels[i] < static_cast<int>(this->Costs[i].size()); ++levels[i])
      {
        could = could ||
          (this->TrueTotal(levels) <= this->Targets.back() &&
            error - this->Error(levels) >= 0.05 * error);
      }
      levels[i] = level;
    }
    return could;
  }

private:
  std::deque<FrameCost> Pending;
  int SinceSpike = 100;
};

/// Four knobs as in a scene with global illumination, with costs as their work promises: floor 4.9 ms, most 15 ms.
inline Simulator FourKnobs(std::uint64_t seed)
{
  Simulator simulator;
  simulator.Numbers.State = seed;
  simulator.Knobs = {
    { "probes", false, { { 64, 0.20 }, { 128, 0.08 }, { 256, 0.03 }, { 512, 0.0 } } },
    { "reflections", true, { { 1, 0.30 }, { 2, 0.12 }, { 4, 0.0 } } },
    { "occlusion", true, { { 4, 0.05 }, { 8, 0.02 }, { 16, 0.008 }, { 32, 0.0 } } },
    { "shadows", true, { { 1, 0.10 }, { 3, 0.03 }, { 9, 0.0 } } },
  };
  simulator.Costs = {
    { 0.6, 1.15, 2.25, 4.5 },
    { 0.7, 1.4, 2.8 },
    { 0.35, 0.7, 1.3, 2.6 },
    { 0.25, 0.7, 2.1 },
  };
  return simulator;
}
}
