// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/AdaptivePlacement.h"

#include <algorithm>
#include <numeric>

namespace penumbra
{
namespace
{
constexpr int BrightnessSamples = 32; // enough to tell lit positions from dark ones

// Limits for the number of surface points at which a field's error is measured.
constexpr int MinimumPoints = 16384;
constexpr int MaximumPoints = 65536;

double Sum(const std::vector<PointError>& errors)
{
  return std::accumulate(errors.begin(), errors.end(), 0.0,
    [](double sum, const PointError& error) { return sum + error.Error; });
}

ProbeProgress SubProgress(const ProbeProgress& progress, double from, double to)
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
      !PlaceProbes(
        this->Stage, field, number, brightness, SubProgress(this->Progress, first, middle)))
    {
      return std::nullopt;
    }
    if (!TraceVisibility(this->Stage, field, number, SubProgress(this->Progress, middle, last)))
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
  if (probes < MinimumForSeveralGrids)
  {
    return this->Place(around);
  }
  // Rough shares of the work.
  const auto withProgress = [this](double from, double to) {
    return AdaptivePlacement{ this->Stage, this->Gather, SubProgress(this->Progress, from, to),
      this->Relocate };
  };
  std::optional<ProbeField> single = withProgress(0.0, 0.25).Place(around);
  if (!single)
  {
    return single;
  }
  LightTrial trial;
  if (!trial.Prepare(
        this->Stage, bounds, std::clamp(16 * probes, MinimumPoints, MaximumPoints), this->Gather))
  {
    return this->Progress(1.0) ? single : std::nullopt; // nothing is lit
  }
  const std::vector<PointError> singleErrors =
    trial.MeasureErrors(this->Stage, *single, this->Gather);
  if (singleErrors.empty() || !this->Progress(0.55))
  {
    return std::nullopt;
  }
  const ProbeGrids grids = AdaptiveGrids(bounds, probes, singleErrors);
  if (grids.Count() == 1)
  {
    return this->Progress(1.0) ? single : std::nullopt;
  }
  std::optional<ProbeField> several = withProgress(0.55, 0.85).Place(grids);
  if (!several)
  {
    return several;
  }
  const std::vector<PointError> severalErrors =
    trial.MeasureErrors(this->Stage, *several, this->Gather);
  if (severalErrors.empty() || !this->Progress(1.0))
  {
    return std::nullopt;
  }
  tried = { grids.Count(), Sum(severalErrors) / Sum(singleErrors) };
  return AreClearlyLess(severalErrors, singleErrors) ? several : single;
}
}
