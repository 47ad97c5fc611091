// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "budget/Governor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace penumbra
{
namespace
{
// Measured at the lowest levels before the first choice; enough for a median.
constexpr int StartFrames = 3;
// Without a change of the scene; else it is an animation, and changes are no news.
constexpr int QuietFrames = 30;
// Number of frames in which costs of a changed scene are learned faster.
constexpr int NewFrames = 16;
constexpr int FloorFrames = 30;

template <typename T>
void Append(std::deque<T>& values, T value, std::size_t most)
{
  values.push_back(value);
  if (values.size() > most)
  {
    values.pop_front();
  }
}
}

const std::vector<int>& Governor::Choose(const std::vector<Knob>& knobs, const Situation& now)
{
  ++this->Number;
  this->Adopt(knobs);
  this->Note(now);
  if (!this->IsStarted)
  {
    if (this->Totals.size() >= StartFrames)
    {
      this->IsStarted = this->IsProbing = true;
      this->ProbedKnob = -1;
      this->SettleFrom = this->Number;
      const double limit = std::min(this->Target(), DownShare * this->Budget);
      this->Set(ChooseLevels(this->Values(1.0), limit - this->Model.Rest(this->Pixels)));
    }
  }
  else if (this->IsProbing)
  {
    this->Probe();
  }
  else if (const double overrun = this->OverrunNow(); overrun > 0.0)
  {
    this->GoDown(overrun);
  }
  else
  {
    this->GoUp();
  }
  PastFrame& choice = this->PastFrames[this->Number % this->PastFrames.size()];
  choice.Frame = this->Number;
  choice.Levels = this->Levels;
  choice.Pixels = this->Pixels;
  choice.Predicted = this->PredictedTotal();
  // The model needs some frames to learn from a change.
  choice.IsSteady = this->IsStarted && !this->IsWithin(this->Since, 8);
  return this->Levels;
}

void Governor::Adopt(const std::vector<Knob>& knobs)
{
  const std::vector<int> origins = this->Model.SetKnobs(knobs);
  bool isSame = origins.size() == this->Knobs.size();
  for (std::size_t i = 0; i < origins.size(); ++i)
  {
    isSame = isSame && origins[i] == static_cast<int>(i);
  }
  this->Knobs = knobs;
  if (isSame && this->Number > 1)
  {
    return;
  }
  const std::vector<int> chosen = this->WithoutProbe();
  std::vector<int> levels;
  std::vector<Bar> bars;
  for (const int origin : origins)
  {
    levels.push_back(origin >= 0 ? chosen[origin] : 0);
    bars.push_back(origin >= 0 ? this->Bars[origin] : Bar{});
  }
  this->Levels = levels;
  this->Bars = bars;
  this->Left.assign(levels.size(), {});
  this->IsStarted = this->IsProbing = false;
  this->LastUp = Never;
  this->Accepted = this->Since = this->Number;
  this->Totals.clear();
  this->Predictions.clear();
}

void Governor::Note(const Situation& now)
{
  const double most = 1e12;
  this->Budget = std::isnan(now.Budget) ? 0.0 : std::clamp(now.Budget, 0.0, most);
  this->Model.SetGuess(
    0.25 * this->Budget); // low enough to be tried, high enough to be tried alone
  const double pixels = std::isfinite(now.Pixels) && now.Pixels > 0.0 ? now.Pixels : this->Pixels;
  this->PixelsGrew = pixels > this->Pixels;
  if (pixels != this->Pixels || (now.SceneChanged && !this->IsWithin(this->LastScene, QuietFrames)))
  {
    const bool isLarge = pixels == this->Pixels || std::abs(pixels / this->Pixels - 1.0) > 0.05;
    this->LastJump = pixels >= this->Pixels ? this->Number : this->LastJump;
    this->SettleFrom = isLarge ? this->Number : this->SettleFrom;
    this->Set(this->WithoutProbe()); // costs have changed
    this->IsProbing = false;
    this->Since = this->Number;
    this->Totals.clear();
    this->Predictions.clear();
    for (Bar& bar : this->Bars)
    {
      bar.Until = isLarge ? 0 : bar.Until;
    }
  }
  this->Pixels = pixels;
  this->LastScene = now.SceneChanged ? this->Number : this->LastScene;
}

void Governor::Measure(const FrameCost& cost)
{
  const PastFrame& choice =
    this->PastFrames[static_cast<std::size_t>(std::max(cost.Frame, 0LL)) % this->PastFrames.size()];
  bool isValid = cost.Frame > 0 && choice.Frame == cost.Frame && cost.Frame >= this->Accepted &&
    cost.Frame > this->LastMeasured && cost.ByKnob.size() == choice.Levels.size() &&
    std::isfinite(cost.Total) && cost.Total >= 0.0;
  for (const double time : cost.ByKnob)
  {
    isValid = isValid && std::isfinite(time) && time >= 0.0;
  }
  if (!isValid)
  {
    return;
  }
  this->LastMeasured = cost.Frame;
  const bool isAfter = cost.Frame >= this->LastJump;
  const bool isNew = isAfter && cost.Frame < this->LastJump + NewFrames;
  const bool isSlow =
    isAfter && cost.Frame <= this->LastJump + JumpFrames && cost.Total > this->Budget;
  this->Model.Learn({ choice.Levels, choice.Pixels, cost.Total, cost.ByKnob, isNew, isSlow });
  if (cost.Frame >= this->Since)
  {
    Append(this->Totals, cost.Total, MostTotals);
    Append(this->Predictions, this->PredictedTotal(), MostTotals);
    if (choice.IsSteady && choice.Predicted > 0.0)
    {
      Append(this->Residuals, cost.Total / choice.Predicted - 1.0, 128);
    }
    this->WatchFloor();
  }
}

void Governor::WatchFloor()
{
  const bool isHigh = this->IsLowest(this->Levels) && this->MedianTotal() > this->Budget;
  this->FloorEvidence = std::clamp(this->FloorEvidence + (isHigh ? 1 : -1), 0, FloorFrames);
  // Half the evidence must vanish before the flag does, so that it does not flicker.
  this->FloorIsHigh = this->FloorEvidence >= (this->FloorIsHigh ? FloorFrames / 2 : FloorFrames);
}

double Governor::Floor() const
{
  return this->PredictedTotal(std::vector<int>(this->Levels.size(), 0));
}

double Governor::Predicted(int knob, int level) const
{
  return this->Model.Predict(knob, level, this->Pixels);
}

double Governor::TargetFor(double milliseconds) const
{
  // 95 % of frames shall be below the budget. The quantile is higher, as it rests on few frames. Spikes are no reason for
  // a margin, as none would be large enough, unless they are frequent.
  std::vector<double> usual;
  for (const double residual : this->Residuals)
  {
    if (residual < SpikeShare - 1.0)
    {
      usual.push_back(residual);
    }
  }
  if (this->Residuals.size() >= 20 && 10 * usual.size() < 9 * this->Residuals.size())
  {
    usual.assign(this->Residuals.begin(), this->Residuals.end());
  }
  double quantile = 0.0;
  if (!usual.empty())
  {
    const auto at =
      usual.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(usual.size()));
    std::nth_element(usual.begin(), at, usual.end());
    quantile = *at;
  }
  quantile = usual.size() < 64 ? std::max(quantile, 0.1) : quantile; // few frames prove little
  return milliseconds * std::clamp(1.0 / (1.0 + std::max(quantile, 0.0)), 0.78, 0.95);
}

void Governor::Set(const std::vector<int>& levels)
{
  if (levels != this->Levels)
  {
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      if (levels[i] != this->Levels[i])
      {
        this->Left[i] = { this->Levels[i], this->Number };
      }
    }
    this->Levels = levels;
    this->LastChange = this->Since = this->Number;
    this->Totals.clear();
    this->Predictions.clear();
    ++this->Changes;
  }
}
}
