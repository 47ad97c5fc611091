// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked probes in main memory, and their conversion to and from a VTK image, which users get and files store. The
 * points of the image are the grid points, or all probes in a row if there are several grids.
 */
#pragma once

#include "probes/ProbeGrids.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{
struct ProbeField
{
  static constexpr int Harmonics = 27; ///< nine coefficients of red, green and blue
  static constexpr int DistanceTexels = GI_FIELD_DISTANCE; ///< width of an octahedral map
  static constexpr int Distances = 2 * DistanceTexels * DistanceTexels;

  ProbeGrids Grids;
  /// Offset of each probe from its grid point, in cells, less than half a cell along each axis.
  std::vector<glm::vec3> Offsets;
  /// Incoming radiance: Harmonics numbers per probe.
  std::vector<float> Light;
  /// Means and standard deviations of distances, in units of Reach(): Distances numbers per probe.
  std::vector<float> Distance;
  std::vector<int> Sight;   ///< visible neighbours, as bits, see glsl/probes/field.glsl
  std::vector<float> Backs; ///< backface ratio
  std::string Scene;        ///< BakedScene::ToText() of the baked scene
  int Samples = 0;          ///< number of paths per probe in Light

  explicit ProbeField(const ProbeGrids& grids = ProbeGrids());
  bool IsEmpty() const { return this->Grids.Size() == 0; }
  glm::dvec3 Position(int probe) const;
  /// The positions of the probes in [first, last).
  std::vector<glm::dvec3> Positions(int first, int last) const;
  /// Maximum distance that a grid's probes store; larger ones count as this.
  double Reach(int grid) const;

  /// Throws std::invalid_argument, with what is missing or wrong, if ToImage() did not write the image.
  static ProbeField FromImage(vtkImageData* image);
  /// compact: store light and distances as half floats.
  void ToImage(vtkImageData* image, bool compact) const;
};

/// The offsets of the thirteen neighbours whose visibility a probe stores.
std::array<glm::ivec3, 13> ProbeNeighbours();
}
