// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The module's light gatherer, for vectors of points.
#pragma once

#include "bake/lightmap/Surfaces.h"

#include <vtkNew.h>

#include <functional>

class vtkGILightGatherer;

namespace penumbra::lightmap
{
struct BakeSettings;

class GatherLight
{
public:
  GatherLight(vtkRenderer* renderer, const BakeSettings& settings);
  ~GatherLight();

  /// Sets which light to include. By default it is indirect light only.
  void Include(bool indirect, bool direct);

  /// Computes means over samples: light with Channels() values per point, and the share of rays that hit back faces. Throws
  /// a Failure.
  void operator()(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
    int firstSample, int samples, const std::function<void(double)>& advance);

  int Channels() const { return this->Directional ? 12 : 3; }
  std::vector<float> Light;
  std::vector<float> Backs;

  /// Number of lights that follow the camera, which are left out. Valid after the first call.
  int CameraLights() const;

private:
  vtkRenderer* Renderer;
  bool Directional;
  bool Indirect = true; ///< included
  vtkNew<vtkGILightGatherer> Gatherer;
};
}
