// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/AdaptivePlacement.h"

#include <algorithm>
#include <numeric>

namespace penumbra
{
namespace
{
constexpr int BrightnessSamples = 32; // to tell a lit place from one that is not

// At how many points of surfaces a field is judged.
constexpr int LeastPoints = 16384;
constexpr int MostPoints = 65536;

double Sum(const std::vector<ErrorAt>& errors)
{
  return std::accumulate(errors.begin(), errors.end(), 0.0,
    [](double sum, const ErrorAt& error) { return sum + error.Error; });
}

ProbeProgress PartOf(const ProbeProgress& progress, double from, double to)
{
  return [&progress, from, to](double done) { return progress(from + (to - from) * done); };
}
}

std::optional<ProbeField> AdaptivePlacement::Place(const ProbeGrids& grids) const
{
  const auto brightness = [this](const std::vector<glm::dvec3>& points) {
    std::vector<double> sums;
    const std::vector<float> light = this->Gather(points, {}, 0, BrightnessSamples, nullptr);
    for (std::size_t i = 0; i < light.size(); i += ProbeField::Harmonics)
    {
      sums.push_back(light[i] + light[i + 1] + light[i + 2]);
    }
    return sums;
  };
  ProbeField field(grids);
  for (int number = 0; number < grids.Count(); ++number)
  {
    const double first = static_cast<double>(grids.Begin(number)) / grids.Size();
    const double last = static_cast<double>(grids.Begin(number + 1)) / grids.Size();
    const double middle = this->Relocate ? 0.5 * (first + last) : first;
    if (this->Relocate &&
      !PlaceProbes(this->Stage, field, number, brightness, PartOf(this->Progress, first, middle)))
    {
      return std::nullopt;
    }
    if (!LookAround(this->Stage, field, number, PartOf(this->Progress, middle, last)))
    {
      return std::nullopt;
    }
  }
  return field;
}

std::optional<ProbeField> AdaptivePlacement::PlaceBest(
  const std::array<double, 6>& bounds, int probes, TriedGrids& tried) const
{
  const ProbeGrid around = ProbeGrid::Around(bounds, probes);
  if (probes < LeastOfSeveral)
  {
    return this->Place(around);
  }
  // Shares of the work, roughly.
  const auto during = [this](double from, double to) {
    return AdaptivePlacement{ this->Stage, this->Gather, PartOf(this->Progress, from, to),
      this->Relocate };
  };
  std::optional<ProbeField> one = during(0.0, 0.25).Place(around);
  if (!one)
  {
    return one;
  }
  LightTrial trial;
  if (!trial.Prepare(
        this->Stage, bounds, std::clamp(16 * probes, LeastPoints, MostPoints), this->Gather))
  {
    return this->Progress(1.0) ? one : std::nullopt; // nothing is lit
  }
  const std::vector<ErrorAt> errors = trial.Judge(this->Stage, *one, this->Gather);
  if (errors.empty() || !this->Progress(0.55))
  {
    return std::nullopt;
  }
  const ProbeGrids grids = AdaptiveGrids(bounds, probes, errors);
  if (grids.Count() == 1)
  {
    return this->Progress(1.0) ? one : std::nullopt;
  }
  std::optional<ProbeField> several = during(0.55, 0.85).Place(grids);
  if (!several)
  {
    return several;
  }
  const std::vector<ErrorAt> others = trial.Judge(this->Stage, *several, this->Gather);
  if (others.empty() || !this->Progress(1.0))
  {
    return std::nullopt;
  }
  tried = { grids.Count(), Sum(others) / Sum(errors) };
  return AreClearlyLess(others, errors) ? several : one;
}
}
