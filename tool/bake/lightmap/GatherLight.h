// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The module's gatherer for vectors of points.
#pragma once

#include "bake/lightmap/Surfaces.h"

#include <vtkNew.h>

#include <functional>

class vtkGILightGatherer;

namespace penumbra::lightmap
{
class GatherLight
{
public:
  GatherLight(vtkRenderer* renderer, int bounces, bool directional);
  ~GatherLight();

  /// What counts from now on; at first all but the lamps' own light.
  void Count(bool indirect, bool lamps);

  /// Means over these samples: Channels() values of light for each point, and the share of rays that met backs.
  /// Throws a Failure.
  void operator()(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
    int firstSample, int samples, const std::function<void(double)>& advance);

  int Channels() const { return this->Directional ? 12 : 3; }
  std::vector<float> Light;
  std::vector<float> Backs;

  /// What the scene has that is not in the light, a sentence each; after the first call.
  std::vector<std::string> Notes() const;

private:
  vtkRenderer* Renderer;
  bool Directional;
  bool Indirect = true; // counts
  vtkNew<vtkGILightGatherer> Gatherer;
};
}
