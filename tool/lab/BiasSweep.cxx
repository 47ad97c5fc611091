// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/BiasSweep.h"

#include <vtkGITechnique.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
constexpr const char* Ending = "-bias";

const BiasSample& BestOf(const BiasSample* first, const BiasSample* last, const BiasLimits& limits)
{
  return *std::min_element(first, last, [&limits](const BiasSample& a, const BiasSample& b) {
    return ShareOfLimits(a.Errors, limits) < ShareOfLimits(b.Errors, limits);
  });
}

/// Between acne below and gaps above: the middle, as far from the one as from the other. Where the
/// window has no such end in the sweep, the best.
double Choose(
  const BiasSample* first, const BiasSample* last, bool bounded, const BiasLimits& limits)
{
  if (!bounded)
  {
    return BestOf(first, last, limits).Bias;
  }
  const double middle = (first->Bias + (last - 1)->Bias) / 2;
  return std::min_element(first, last, [middle](const BiasSample& a, const BiasSample& b) {
    return std::abs(a.Bias - middle) < std::abs(b.Bias - middle);
  })->Bias;
}
}

double ShareOfLimits(const BiasErrors& errors, const BiasLimits& limits)
{
  return std::max(errors.Acne / limits.Acne, errors.Gap() / limits.Gap);
}

std::optional<BiasWindow> BiasSweep::Window(const BiasLimits& limits) const
{
  std::optional<BiasWindow> widest;
  const BiasSample* end = this->Samples.data() + this->Samples.size();
  const auto within = [&limits](const BiasSample& sample) {
    return ShareOfLimits(sample.Errors, limits) <= 1;
  };
  for (const BiasSample* first = std::find_if(this->Samples.data(), end, within); first != end;)
  {
    const BiasSample* last = std::find_if_not(first, end, within);
    const bool bounded = first != this->Samples.data() && last != end;
    const BiasWindow found{ first->Bias, (last - 1)->Bias, last == end,
      Choose(first, last, bounded, limits) };
    if (!widest || found.High - found.Low > widest->High - widest->Low)
    {
      widest = found;
    }
    first = std::find_if(last, end, within);
  }
  return widest;
}

const BiasSample& BiasSweep::Best(const BiasLimits& limits) const
{
  const auto window = this->Window(limits);
  if (!window)
  {
    return BestOf(this->Samples.data(), this->Samples.data() + this->Samples.size(), limits);
  }
  return *std::find_if(this->Samples.begin(), this->Samples.end(),
    [&window](const BiasSample& sample) { return sample.Bias == window->Choice; });
}

std::vector<std::string> BiasKinds(vtkGITechnique* technique)
{
  std::vector<std::string> kinds;
  const std::string ending = Ending;
  for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
  {
    const std::string name = technique->GetParameterName(i);
    const bool bias = std::string(technique->GetParameterType(i)) == "double" &&
      name.size() > ending.size() &&
      name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    if (bias)
    {
      kinds.push_back(name.substr(0, name.size() - ending.size()));
    }
  }
  return kinds;
}

std::vector<double> EvenSteps(double low, double high, int count)
{
  std::vector<double> steps;
  for (int i = 0; i < count; ++i)
  {
    steps.push_back(i + 1 == count ? high : low + (high - low) * i / (count - 1));
  }
  return steps;
}
}
