// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points on a scene's surfaces with the light that arrives there, to judge fields of probes by before they are baked.
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
  /// Light at points, as vtkGILightGatherer has it, of so many paths from a first one on: with normals 3 numbers each,
  /// without (empty) 27. Empty where it was ended. surroundings: what there is around points (3 numbers), if asked for.
  using Gather = std::function<std::vector<float>(const std::vector<glm::dvec3>& points,
    const std::vector<glm::dvec3>& normals, int firstSample, int samples,
    std::vector<float>* surroundings)>;

  /// At about so many points. Returns false where it was ended, or where there are no surfaces in any light.
  bool Prepare(
    GatherStage& stage, const std::array<double, 6>& bounds, int points, const Gather& gather);

  /// How far off light is that a field's probes would give: of each point its share in the mean of squared errors, over
  /// the light's square there and a hundredth of its mean's. Without bias: chance makes some negative. Empty where it
  /// was ended.
  std::vector<ErrorAt> Judge(GatherStage& stage, ProbeField field, const Gather& gather) const;

private:
  void Pick(const std::vector<float>& found, const glm::dvec3& origin,
    const std::array<double, 6>& bounds, std::size_t count);
  bool ForgetTheUnseen(const std::vector<float>* surroundings);
  std::vector<float> LightOf(GatherStage& stage, const ProbeField& field) const;

  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals;
  std::vector<double> Weights; ///< of the points' errors; add up to 1
  std::vector<float> Light[2]; ///< by different paths
  double MeanSquare = 0.0;     ///< square of the mean of Light
};
}
