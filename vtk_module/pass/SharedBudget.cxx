// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// One frame budget for several processes that draw a picture together. Each tells the others what it knows before a frame, in
// one reduction by maximum, and all take the same decision from the result. Flags are chosen so that a maximum is right
// for them, too.
#include "pass/FrameBudget.h"

#include "vtkGITechnique.h"

#include <algorithm>

namespace penumbra
{
namespace
{
// Frames whose costs are shared at once. Times arrive at most four frames late.
constexpr std::size_t MostWaiting = 8;

// Numbers at the beginning. Of pairs, the second is negative: they belong together if all processes have the same value.
enum Value
{
  BudgetValue,
  PixelsValue,
  SceneValue,
  FrameValue,
  MinusFrame,
  WaitingValue,
  MinusWaiting,
  LevelsValue,
  MinusLevels,
  Values
};

// Then comes whether each technique took part, and for each waiting frame its progress, its total, and its knobs.
struct Layout
{
  std::size_t Techniques;

  std::size_t Part(std::size_t technique) const { return Values + technique; }
  std::size_t Progress(std::size_t frame) const
  {
    return Values + this->Techniques + frame * (2 + this->Techniques);
  }
  std::size_t Total(std::size_t frame) const { return this->Progress(frame) + 1; }
  std::size_t Knob(std::size_t frame, std::size_t knob) const
  {
    return this->Progress(frame) + 2 + knob;
  }
  std::size_t Size() const { return this->Progress(MostWaiting); }
};
}

double FrameBudget::FingerprintOf(const std::vector<int>& levels)
{
  long long sum = 1;
  for (const int level : levels)
  {
    sum = (31 * sum + level + 1) % 1000000007LL;
  }
  return static_cast<double>(sum);
}

std::vector<double> FrameBudget::Offer(const Techniques& techniques, const Situation& situation)
{
  const Layout layout{ techniques.size() };
  std::vector<double> values(layout.Size(), 0.0);
  const auto setPair = [&values](Value first, double value) {
    values[first] = value;
    values[first + 1] = -value;
  };
  values[BudgetValue] = situation.Budget;
  values[PixelsValue] = situation.Pixels;
  values[SceneValue] = this->SceneChanged || situation.SceneChanged ? 1.0 : 0.0;
  setPair(FrameValue, static_cast<double>(this->Chooser.Frame()));
  setPair(WaitingValue, static_cast<double>(this->Pending.size()));
  setPair(LevelsValue, this->SharedLevels);
  const std::vector<double> tookPart = TookPart(techniques);
  std::copy(
    tookPart.begin(), tookPart.end(), values.begin() + static_cast<std::ptrdiff_t>(layout.Part(0)));
  for (std::size_t i = 0; i < std::min(this->Pending.size(), MostWaiting); ++i)
  {
    PendingFrame& pending = this->Pending[i];
    if (pending.Number == NotDrawn)
    {
      pending.Known = Progress::Measured;
      pending.Cost.ByKnob.assign(pending.Knobs.size(), 0.0);
    }
    values[layout.Progress(i)] = static_cast<double>(pending.Known);
    values[layout.Total(i)] = pending.Cost.Total;
    for (std::size_t k = 0; k < pending.Cost.ByKnob.size(); ++k)
    {
      values[layout.Knob(i, k)] = pending.Cost.ByKnob[k];
    }
  }
  return values;
}

void FrameBudget::Accept(const Techniques& techniques, const std::vector<double>& most)
{
  this->End();
  const Layout layout{ techniques.size() };
  const auto isSame = [&most](Value first) { return most[first] == -most[first + 1]; };
  if (!isSame(FrameValue) || !isSame(WaitingValue) || !isSame(LevelsValue))
  {
    // A process has begun afresh, such as in a new context, or has drawn frames alone.
    this->Chooser = Governor();
    this->Pending.clear();
    this->Known.clear();
  }
  for (std::size_t i = 0; i < std::min(this->Pending.size(), MostWaiting); ++i)
  {
    PendingFrame& pending = this->Pending[i];
    const auto known = static_cast<Progress>(static_cast<int>(most[layout.Progress(i)]));
    if (known == Progress::Pending)
    {
      break; // until all know it; later frames wait for it
    }
    pending.Known = known;
    pending.Shared = false;
    pending.Cost.Total = most[layout.Total(i)];
    for (std::size_t k = 0; k < pending.Knobs.size(); ++k)
    {
      pending.Cost.ByKnob.resize(pending.Knobs.size());
      pending.Cost.ByKnob[k] = most[layout.Knob(i, k)];
    }
  }
  this->PassOn();
  while (this->Pending.size() >= MostWaiting)
  {
    this->Pending.pop_front(); // never timed by someone
  }
  Situation situation;
  situation.Budget = most[BudgetValue];
  situation.Pixels = most[PixelsValue];
  situation.SceneChanged = most[SceneValue] > 0.0;
  const auto parts = most.begin() + static_cast<std::ptrdiff_t>(layout.Part(0));
  this->Decide(techniques, { parts, parts + static_cast<std::ptrdiff_t>(techniques.size()) },
    situation, NotDrawn);
  this->SceneChanged = false;
  this->SharedLevels = FingerprintOf(this->Levels);
  if (this->Current == State::Moving)
  {
    this->Pending.back().Shared = true;
    this->IsDecided = true;
  }
}
}
