// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Decisions of the governor: when levels change, and to which.
 */
#include "budget/Governor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace penumbra
{
namespace
{
// Number of frames after a start or a change of the scene by which costs are known well enough to exchange levels between knobs.
constexpr int FreshFrames = 24;
// Frames from a change of levels to a step up.
constexpr int UpWait = 30;
// Short enough to settle within a second.
constexpr int UpWaitSettling = 8;
// Measured frames that must support a step up.
constexpr std::size_t UpSupport = 30;
// While settling, if times fluctuate much, and else.
constexpr std::size_t UpSupportNoisy = 20;
constexpr std::size_t UpSupportSettling = 7;
// Frames of the same levels of which a few slow ones prove that they are too expensive.
constexpr std::size_t SlowSupport = 60;
// Frames from a step down to a step up, so that no change is undone soon.
constexpr int DownWait = 100;
constexpr int DownWaitSettling = 16;
// Frames for which a knob does not return to the level that it had.
constexpr int KeepFrames = 60;
// Number of frames within which a step down is blamed on the last step up.
constexpr int BlameFrames = 60;
// Number of frames for which such a step is barred; doubles each time.
constexpr int BarFrames = 240;
constexpr int MostBarFrames = 1 << 16;
// Number of frames after a start or a change of the scene in which unmeasured levels may be tried, so that a failure
// is over once costs are settled.
constexpr int TryFrames = 48;
// Share of the budget that is used at most while few frames support a step up.
constexpr double SettlingShare = 0.9;
// Share of the present error that a step up must remove to be worth a visible change.
constexpr double LeastGain = 0.05;
// The same for an exchange of levels between knobs, which shows in several places.
constexpr double LeastExchange = 0.2;
// A level that adds less than this share of the budget counts as free, and stays when nothing else fits.
constexpr double FreeShare = 1e-3;
// Times the added cost of a level that was never measured, as it may prove higher: in a choice from scratch.
constexpr double Caution = 1.5;
// Frames in which a level is probed: enough for a median.
constexpr int ProbeFrames = 3;
// Times the budget: most that a frame may seem to cost while a level is probed.
constexpr double MostProbed = 1.25;
// Times the budget: most that a try may seem to cost.
constexpr double MostTried = 1.5;
// Times by which the added cost of a level that was never measured may be wrong, up or down.
constexpr double Surprise = 3.0;
}

bool Governor::IsLowest(const std::vector<int>& levels) const
{
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    const int knob = static_cast<int>(i);
    const double added = this->Predicted(knob, levels[i]) - this->Predicted(knob, 0);
    if (levels[i] > 0 && added > FreeShare * this->Budget)
    {
      return false;
    }
  }
  return true;
}

bool Governor::IsWithin(long long frame, int frames) const
{
  return this->Number - frame < frames;
}

bool Governor::IsSettling() const
{
  return this->IsWithin(this->SettleFrom, SettleFrames);
}

std::vector<LevelValues> Governor::Values(double caution) const
{
  std::vector<LevelValues> all;
  for (std::size_t i = 0; i < this->Knobs.size(); ++i)
  {
    const int knob = static_cast<int>(i);
    const Bar& bar = this->Bars[i];
    const int current = this->Levels[i];
    LevelValues values;
    values.Most = std::max(static_cast<int>(this->Knobs[i].Levels.size()) - 1, 0);
    if (bar.Until > this->Number)
    {
      values.Most = std::min(values.Most, std::max(bar.Level - 1, current));
    }
    for (int level = 0; level == 0 || level < static_cast<int>(this->Knobs[i].Levels.size());
         ++level)
    {
      const double cost = this->Predicted(knob, level);
      const double added = cost - this->Predicted(knob, current);
      const bool isGuess = level > current && !this->Model.IsSeen(knob, level) && added > 0.0;
      values.Costs.push_back(isGuess ? cost + (caution - 1.0) * added : cost);
      const double error = this->Knobs[i].Levels.empty() ? 0.0 : this->Knobs[i].Levels[level].Error;
      values.Errors.push_back(std::isfinite(error) ? error : 0.0);
    }
    all.push_back(values);
  }
  return all;
}

std::vector<int> Governor::LevelsFor(double milliseconds) const
{
  std::vector<LevelValues> values = this->Values(1.0);
  for (LevelValues& knob : values)
  {
    knob.Most = static_cast<int>(knob.Costs.size()) - 1; // bars are those of the budget
  }
  return ChooseLevels(values, this->TargetFor(milliseconds) - this->Rest());
}

double Governor::MedianTotal() const
{
  const std::size_t count = std::min<std::size_t>(this->Totals.size(), 5);
  std::vector<double> last(
    this->Totals.end() - static_cast<std::ptrdiff_t>(count), this->Totals.end());
  std::sort(last.begin(), last.end());
  return last.empty() ? 0.0 : last[(count - 1) / 2];
}

bool Governor::IsOftenSlow() const
{
  // A median notices only when half of the frames are slow.
  const double spike = SpikeShare * this->PredictedTotal();
  const auto slowIn = [&](std::size_t most) {
    const std::size_t count = std::min(this->Totals.size(), most);
    return std::count_if(this->Totals.end() - static_cast<std::ptrdiff_t>(count),
      this->Totals.end(), [&](double total) { return total > this->Budget && total < spike; });
  };
  // Few slow frames prove little, and are no reason to undo a change soon.
  const bool isLong = this->Totals.size() >= SlowSupport;
  return slowIn(30) >= 6 ||
    (isLong && 12 * slowIn(MostTotals) > static_cast<int>(this->Totals.size()));
}

bool Governor::IsMistaken() const
{
  // While settling, a level may prove dearer than predicted, and leave less than the usual fluctuation.
  const double limit = 0.5 * (this->Target() + this->Budget);
  return this->IsSettling() && this->Predictions.size() >= UpSupportSettling &&
    *std::min_element(this->Predictions.end() - 3, this->Predictions.end()) > limit;
}

double Governor::OverrunNow() const
{
  if (this->IsLowest(this->Levels))
  {
    return 0.0;
  }
  const double predicted = std::max(this->PredictedTotal(), 1e-9);
  const std::size_t count = this->Totals.size();
  if (this->PixelsGrew)
  {
    return predicted > this->Target() ? 1.0 : 0.0;
  }
  if (count >= 3 && this->MedianTotal() > this->Budget)
  {
    return std::max(this->MedianTotal() / predicted, 1.0);
  }
  if (count >= 2)
  {
    const double lower = std::min(this->Totals[count - 1], this->Totals[count - 2]);
    if (lower > 1.25 * this->Budget)
    {
      return std::max(lower / predicted, 1.0);
    }
  }
  // The first frame of new levels may be slow only because of the change.
  const bool isSecond = count >= 2 || this->LastChange < this->LastJump;
  if (count >= 1 && isSecond && this->IsWithin(this->LastJump, JumpFrames) &&
    this->Totals.back() > this->Budget)
  {
    // The model has already believed this frame, which may have been faster than usual.
    return this->Budget / this->Target();
  }
  return this->IsMistaken() || this->IsOftenSlow() ? 1.0 : 0.0;
}

std::vector<int> Governor::WithoutProbe() const
{
  std::vector<int> levels = this->Levels;
  if (this->IsProbing && this->ProbedKnob >= 0)
  {
    --levels[this->ProbedKnob];
  }
  return levels;
}

void Governor::Probe()
{
  const bool isSlow = !this->Totals.empty() && this->Totals.back() > SpikeShare * this->Budget;
  if (this->IsWithin(this->Since, ProbeFrames) && !isSlow)
  {
    return;
  }
  const double overrun = this->OverrunNow();
  if (this->ProbedKnob < 0 && overrun > 0.0)
  {
    this->GoDown(overrun); // the choice was wrong: first see whether the next one fits
    return;
  }
  std::vector<int> levels = this->WithoutProbe();
  const auto count = static_cast<int>(levels.size());
  ++this->ProbedKnob;
  while (this->ProbedKnob < count)
  {
    const int knob = this->ProbedKnob;
    const int next = levels[knob] + 1;
    if (next < static_cast<int>(this->Knobs[knob].Levels.size()) && !this->Model.IsSeen(knob, next))
    {
      ++levels[knob];
      if (this->PredictedTotal(levels) <= MostProbed * this->Budget)
      {
        break;
      }
      --levels[knob];
    }
    ++this->ProbedKnob;
  }
  this->IsProbing = this->ProbedKnob < count;
  this->Set(levels);
}

void Governor::GoDown(double overrun)
{
  if (this->IsWithin(this->LastUp, BlameFrames))
  {
    Bar& bar = this->Bars[this->LastUpKnob];
    bar.Level = this->Levels[this->LastUpKnob];
    bar.Length = bar.Length > 0 ? std::min(2 * bar.Length, MostBarFrames) : BarFrames;
    bar.Until = this->Number + bar.Length;
  }
  this->LastUp = Never;
  this->LastDown = this->Number;
  // Whatever the model believes, the new levels must be cheaper than the current ones.
  const double limit = std::min({ this->Target() / overrun, DownShare * this->Budget / overrun,
    0.95 * this->PredictedTotal() });
  std::vector<LevelValues> values = this->Values(Surprise);
  for (std::size_t i = 0; i < values.size() && !this->IsSettling(); ++i)
  {
    values[i].Most = this->Levels[i]; // what is raised now may have to be lowered soon
  }
  this->Set(ChooseLevels(values, limit - this->Rest()));
}

bool Governor::IsSupported(double added) const
{
  // Would the frames since the last change have been fast enough with the step, and their predictions too? A single
  // prediction may be low by chance.
  const double predicted = this->PredictedTotal();
  const double growth = predicted > 0.0 ? (predicted + std::max(added, 0.0)) / predicted : 1.0;
  const std::size_t count = std::min<std::size_t>(this->Totals.size(), UpSupport);
  const auto slow = std::count_if(this->Totals.end() - static_cast<std::ptrdiff_t>(count),
    this->Totals.end(), [&](double total) { return total * growth > this->Budget; });
  const double limit =
    this->IsSettling() ? std::min(this->Target(), SettlingShare * this->Budget) : this->Target();
  // The first predictions still learn from the change.
  const auto isNew =
    static_cast<std::ptrdiff_t>(std::min<std::size_t>(count, UpSupportSettling) / 2);
  const auto first = this->Predictions.end() - static_cast<std::ptrdiff_t>(count) + isNew;
  const double highest =
    first == this->Predictions.end() ? 0.0 : *std::max_element(first, this->Predictions.end());
  const bool isNoisy = this->Target() < SettlingShare * this->Budget;
  const std::size_t few = isNoisy ? UpSupportNoisy : UpSupportSettling;
  const std::size_t least = this->IsSettling() ? few : UpSupport;
  // Do not step from a cost that is still being learned.
  const bool isLearned = this->MedianTotal() > 0.85 * predicted;
  return count >= least && isLearned && 15 * static_cast<std::size_t>(slow) <= count &&
    highest * growth <= limit;
}

void Governor::Refresh(const std::vector<LevelValues>& values, double leastShare)
{
  const double share = this->IsSettling() ? DownShare : 1.0;
  const double limit = std::min(this->Target(), share * this->Budget);
  const std::vector<int> levels = ChooseLevels(values, limit - this->Rest());
  const double added = this->PredictedTotal(levels) - this->PredictedTotal();
  if (this->Error(levels) < (1.0 - leastShare) * this->Error(this->Levels) &&
    this->IsSupported(added))
  {
    this->Set(levels);
  }
}

void Governor::KeepRecent(std::vector<LevelValues>& values) const
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!this->IsWithin(this->Left[i].Frame, KeepFrames))
    {
      continue;
    }
    if (this->Left[i].Level > this->Levels[i])
    {
      values[i].Most = this->Levels[i];
    }
    else
    {
      values[i].Least = this->Levels[i];
    }
  }
}

double Governor::Error(const std::vector<int>& levels) const
{
  double error = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    error += this->Knobs[i].Levels.empty() ? 0.0 : this->Knobs[i].Levels[levels[i]].Error;
  }
  return error;
}

void Governor::GoUp()
{
  const bool isSettling = this->IsSettling();
  if (this->Number == this->SettleFrom + FreshFrames)
  {
    this->Refresh(this->Values(Caution), LeastGain);
    return;
  }
  if (this->IsWithin(this->Since, isSettling ? UpWaitSettling : UpWait) ||
    this->IsWithin(this->LastDown, isSettling ? DownWaitSettling : DownWait))
  {
    return;
  }
  const bool mayTry = this->IsWithin(this->SettleFrom, TryFrames);
  std::vector<LevelValues> values = this->Values(mayTry ? 1.0 : Surprise);
  if (!isSettling)
  {
    this->KeepRecent(values);
  }
  const double error = this->Error(this->Levels);
  const double predicted = this->PredictedTotal();
  LevelStep step = BestStep(values, this->Levels, this->Target() - predicted, LeastGain * error);
  if (step.Knob < 0 && mayTry && predicted < 0.75 * this->Budget)
  {
    // Much of the budget is left: a level that was never measured may be cheaper than it seems. Only while settling, as
    // a try that fails is seen.
    const std::vector<LevelValues> hopeful = this->Values(1.0 / Surprise);
    step = BestStep(hopeful, this->Levels, this->Target() - predicted, LeastGain * error);
    const double seeming = step.Knob < 0 ? 0.0
                                         : this->Predicted(step.Knob, step.Level) -
        this->Predicted(step.Knob, this->Levels[step.Knob]);
    step.Knob = predicted + seeming > MostTried * this->Budget ? -1 : step.Knob;
  }
  if (step.Knob < 0)
  {
    // Single steps end where only an exchange would help.
    if (!isSettling && (this->Number - this->Since) % UpWait == 0)
    {
      this->Refresh(values, LeastExchange);
    }
    return;
  }
  if (!this->IsSupported(step.Cost))
  {
    return;
  }
  std::vector<int> levels = this->Levels;
  levels[step.Knob] = step.Level;
  this->LastUp = this->Number;
  this->LastUpKnob = step.Knob;
  this->Set(levels);
}
}
