// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Measures the error of fields of probes before they are baked, at points on the scene's surfaces whose light is known.
 */
#pragma once

#include "techniques/sh_probes/AdaptiveGrids.h"
#include "techniques/sh_probes/ProbeField.h"

#include <functional>
#include <vector>

namespace penumbra
{
class GatherStage;

class LightTrial
{
public:
  /// Gathers light at points as vtkGILightGatherer does: 3 numbers per point with normals, 27 without (empty). The
  /// result is empty if the work was aborted. surroundings: receives 3 numbers about each point's surroundings unless
  /// nullptr.
  using Gather = std::function<std::vector<float>(const std::vector<glm::dvec3>& points,
    const std::vector<glm::dvec3>& normals, int firstSample, int samples,
    std::vector<float>* surroundings)>;

  /// Find about a number of points on surfaces, and gather their light. Returns false if the work was aborted or no
  /// surface receives light.
  bool Prepare(
    GatherStage& stage, const std::array<double, 6>& bounds, int points, const Gather& gather);

  /// Each point's share of the mean squared error of the light that a field's probes would give. Errors are relative to
  /// the square of the light at the point plus a hundredth of the square of its mean. They are unbiased estimates, some
  /// of which are negative. Empty if the work was aborted.
  std::vector<PointError> MeasureErrors(
    GatherStage& stage, ProbeField field, const Gather& gather) const;

private:
  void SelectPoints(const std::vector<float>& found, const glm::dvec3& origin,
    const std::array<double, 6>& bounds, std::size_t count);
  bool DiscardHidden(const std::vector<float>* surroundings);
  std::vector<float> ProbeLight(GatherStage& stage, const ProbeField& field) const;

  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals;
  std::vector<double> Weights; ///< weights of the points' errors; their sum is 1
  std::vector<float> Light[2]; ///< from independent paths
  double MeanSquare = 0.0;     ///< square of the mean of Light
};
}
