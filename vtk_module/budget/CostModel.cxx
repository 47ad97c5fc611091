// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "budget/CostModel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace penumbra
{
namespace
{
constexpr double RiseRate = 0.5;
constexpr double FallRate = 0.1;
// Even the cheapest level binds resources and starts passes: part of its cost does not shrink with the work.
constexpr double FixedShare = 0.1;
// Number of frames after a change of levels in which a wrong prediction is blamed on the ratio of the levels rather than on
// the scene. Enough for a median to settle.
constexpr int ShapeFrames = 8;
constexpr double LeastFactor = 1e-6; // 0 stands for unknown

double Blend(double mean, double value, bool isFast = false)
{
  return mean + (value > mean || isFast ? RiseRate : FallRate) * (value - mean);
}
}

void CostEstimate::Set(double mean)
{
  this->Mean = mean;
  this->Known = true;
}

double CostEstimate::Median(double value)
{
  this->Values[this->Count % 3] = value;
  this->Count = this->Count < 6 ? this->Count + 1 : 4; // as long as its place among three stays
  const double* values = this->Values;
  if (this->Count < 3)
  {
    return this->Count < 2 ? values[0] : std::min(values[0], values[1]);
  }
  return std::max(
    std::min(values[0], values[1]), std::min(std::max(values[0], values[1]), values[2]));
}

void CostEstimate::Follow(double median, bool isFast)
{
  if (this->Known && !this->Young && this->Count < 2)
  {
    return; // may be a spike
  }
  this->Set(this->Young ? median : Blend(this->Mean, median, isFast));
  this->Young = this->Young && this->Count < 3;
}

void CostModel::KnobCost::SetWork(const Knob& knob)
{
  this->Prior.clear();
  double least = 0.0;
  for (const KnobLevel& level : knob.Levels)
  {
    const double work = std::isfinite(level.Work) ? std::max(level.Work, 0.0) : 0.0;
    least = least > 0.0 ? least : work;
    this->Prior.push_back(work > 0.0 ? FixedShare + work / least : 0.0);
  }
  if (knob.Levels.empty())
  {
    this->Prior.push_back(0.0);
  }
}

double CostModel::KnobCost::Factor(int level) const
{
  const auto isSeen = [](double factor) { return factor > 0.0; };
  const auto here = this->Factors.begin() + level;
  // The nearest known level below, or else above, is wrong in a similar way.
  const auto below =
    std::find_if(std::make_reverse_iterator(here + 1), this->Factors.rend(), isSeen);
  const auto above = std::find_if(here + 1, this->Factors.end(), isSeen);
  if (above == this->Factors.end())
  {
    return below == this->Factors.rend() ? 1.0 : *below;
  }
  // No level costs more than a better one.
  const double most = *above * this->Prior[above - this->Factors.begin()];
  const bool isBounded = below != this->Factors.rend() && below.base() - 1 != here;
  return below == this->Factors.rend() ? *above
    : isBounded                        ? std::min(*below, most / this->Prior[level])
                                       : *below;
}

void CostModel::KnobCost::LearnFactor(int level, double factor, int values)
{
  if (values < 2)
  {
    return; // the first frame of a level may be a spike
  }
  double& known = this->Factors[level];
  known = std::max(this->IsFirst && values <= 3 ? factor : Blend(known, factor), LeastFactor);
}

void CostModel::KnobCost::Learn(int level, double cost, bool isNew, bool isSlow)
{
  const bool works = this->Prior[level] > 0.0;
  CostEstimate& estimate = works ? this->Scale : this->Idle;
  if (level != this->Level)
  {
    this->Level = level;
    this->Frames = 0;
    this->IsFirst = works && !(this->Factors[level] > 0.0);
    estimate.ForgetValues();
  }
  this->Frames = isNew && !this->IsFirst ? ShapeFrames : this->Frames;
  if (isSlow)
  {
    estimate.ForgetValues();
  }
  const double median = estimate.Median(works ? cost / this->Prior[level] : cost);
  ++this->Frames;
  if (!works)
  {
    estimate.Follow(median, isNew);
  }
  else if (estimate.IsYoung() || !(estimate.Get() > 0.0))
  {
    this->Factors[level] = this->Factor(level);
    estimate.Follow(median / this->Factors[level], isNew);
  }
  else if (isSlow)
  {
    estimate.Set(std::max(estimate.Get(), median / this->Factor(level)));
  }
  else if (this->Frames <= ShapeFrames)
  {
    this->LearnFactor(level, median / estimate.Get(), estimate.ValueCount());
  }
  else
  {
    estimate.Follow(median / this->Factor(level), isNew);
  }
}

std::vector<int> CostModel::SetKnobs(const std::vector<Knob>& knobs)
{
  std::vector<KnobCost> costs;
  std::vector<int> origins;
  std::vector<bool> isTaken(this->Costs.size(), false);
  for (const Knob& knob : knobs)
  {
    int origin = -1;
    for (std::size_t i = 0; i < this->Costs.size() && origin < 0; ++i)
    {
      const KnobCost& old = this->Costs[i];
      const bool isSame = !isTaken[i] && old.Technique == knob.Technique &&
        old.PerPixel == knob.PerPixel &&
        old.Factors.size() == std::max<std::size_t>(knob.Levels.size(), 1);
      origin = isSame ? static_cast<int>(i) : -1;
    }
    KnobCost cost;
    if (origin >= 0)
    {
      isTaken[origin] = true;
      cost = this->Costs[origin];
    }
    else
    {
      cost.Technique = knob.Technique;
      cost.PerPixel = knob.PerPixel;
      cost.Factors.assign(std::max<std::size_t>(knob.Levels.size(), 1), 0.0);
    }
    cost.SetWork(knob);
    costs.push_back(cost);
    origins.push_back(origin);
  }
  this->Costs = std::move(costs);
  return origins;
}

void CostModel::Learn(const Sample& sample)
{
  double rest = sample.Total;
  for (std::size_t i = 0; i < this->Costs.size(); ++i)
  {
    KnobCost& cost = this->Costs[i];
    const double time = sample.ByKnob[i];
    cost.Learn(
      sample.Levels[i], cost.PerPixel ? time / sample.Pixels : time, sample.IsNew, sample.IsSlow);
    rest -= time;
  }
  rest = std::max(rest, 0.0);
  if (sample.Pixels != this->RestPixels || sample.IsSlow)
  {
    this->RestCost.Set(this->Rest(sample.Pixels));
    this->RestCost.ForgetValues();
    this->RestPixels = sample.Pixels;
  }
  const double median = this->RestCost.Median(rest);
  if (sample.IsSlow)
  {
    this->RestCost.Set(std::max(this->RestCost.Get(), median));
  }
  else
  {
    this->RestCost.Follow(median, sample.IsNew);
  }
}

double CostModel::Predict(int knob, int level, double pixels) const
{
  const KnobCost& cost = this->Costs[knob];
  const double prior = cost.Prior[level];
  const double unit = cost.PerPixel ? pixels : 1.0;
  if (!(prior > 0.0))
  {
    return cost.Idle.Get() * unit;
  }
  if (!cost.Scale.IsKnown())
  {
    return this->Guess * prior / (1.0 + FixedShare);
  }
  return cost.Scale.Get() * prior * cost.Factor(level) * unit;
}

double CostModel::Rest(double pixels) const
{
  return this->RestCost.Get() * std::max(1.0, pixels / this->RestPixels);
}

double CostModel::Total(const std::vector<int>& levels, double pixels) const
{
  double total = this->Rest(pixels);
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    total += this->Predict(static_cast<int>(i), levels[i], pixels);
  }
  return total;
}

bool CostModel::IsSeen(int knob, int level) const
{
  const KnobCost& cost = this->Costs[knob];
  return cost.Prior[level] > 0.0 ? cost.Factors[level] > 0.0 : cost.Idle.IsKnown();
}
}
