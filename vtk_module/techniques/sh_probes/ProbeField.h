// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probes and what was baked into them, apart from any graphics card; and as an image of VTK, for files and for users,
 * whose points are the grid's places, or where there are several grids all of their probes in a row.
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
  static constexpr int Harmonics = 27;      ///< nine, of red, green and blue each
  static constexpr int DistanceTexels = GI_FIELD_DISTANCE; ///< across an octahedral map
  static constexpr int Distances = 2 * DistanceTexels * DistanceTexels;

  ProbeGrids Grids;
  /// Of each probe: how far it stands off its grid's place, in cells, less than half along each axis.
  std::vector<glm::vec3> Offsets;
  /// Harmonics numbers of each: of the radiance that arrives.
  std::vector<float> Light;
  /// Distances numbers of each: the mean and the standard deviation, in its grid's Reach().
  std::vector<float> Distance;
  std::vector<int> Sight;   ///< bits of neighbours, as glsl/probes/field.glsl has them
  std::vector<float> Backs; ///< share of rays that meet backs of surfaces
  std::string Scene;        ///< BakedScene::ToText() of what was baked
  int Samples = 0;          ///< paths of each probe that Light is the mean of

  explicit ProbeField(const ProbeGrids& grids = ProbeGrids());
  bool IsEmpty() const { return this->Grids.Size() == 0; }
  glm::dvec3 Position(int probe) const;
  /// Of probes from one to another, that one not counted.
  std::vector<glm::dvec3> Positions(int first, int last) const;
  /// Distances beyond it count as this.
  double Reach(int grid) const;

  /// Throws std::invalid_argument, saying what is missing or wrong, where an image is none of ToImage()'s.
  static ProbeField FromImage(vtkImageData* image);
  /// compact: light and distances as half floats.
  void ToImage(vtkImageData* image, bool compact) const;
};

/// The offsets of the thirteen neighbours that a probe keeps a bit for.
std::array<glm::ivec3, 13> ProbeNeighbours();
}
