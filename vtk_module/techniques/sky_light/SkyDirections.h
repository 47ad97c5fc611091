// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Directions drawn from a renderer's environment by its radiance, and the light that arrives where nothing occludes it.
 */
#pragma once

#include "gpu/GLObjects.h"
#include "rays/SkyPictures.h"

#include <glm/glm.hpp>

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkRenderer;
class vtkTexture;

namespace penumbra
{
class SkyDirections
{
public:
  struct Sample
  {
    glm::dvec3 Toward{ 0.0, 0.0,
      1.0 };              ///< direction in the world from which light arrives, unit length
    double Density = 1.0; ///< probability density per solid angle
  };

  /// Update from the renderer. Returns whether the light changed. Without an environment, Shines() is false.
  bool Update(vtkRenderer* renderer);
  bool Shines() const { return this->Open != nullptr; }

  /// Draw direction number `index` of an endless sequence: any contiguous part of it, even a short one, is well
  /// distributed.
  Sample Draw(unsigned int index) const;

  /// Mean radiance of the environment around a direction, as finely as directions are drawn.
  glm::dvec3 Radiance(const glm::dvec3& toward) const;

  /// Irradiance of unoccluded surfaces, divided by pi, by the octahedral normal in the sky's coordinates. Linear lookups
  /// find the outermost texels' neighbours in a border. a: luminance
  const Texture& OpenLight() const { return *this->Open; }
  /// Texels of OpenLight() from one edge of the octahedral square to the other.
  static constexpr int OpenTexels = 32;
  const glm::mat3& ToSky() const { return this->SkyFromWorld; }

private:
  void Build(const SkyPictures& sky);
  void BuildOpenLight(const SkyPictures& sky);
  int CellOf(const glm::dvec3& inSky) const;

  int Columns = 0;
  int Rows = 0;
  std::vector<glm::vec3> Cells;   ///< mean radiances, over longitude and latitude, lowest row first
  std::vector<double> RowSums;    ///< cumulative probabilities of rows
  std::vector<double> ColumnSums; ///< cumulative probabilities within each row
  std::vector<double> Densities;
  std::unique_ptr<Texture> Open;
  glm::mat3 SkyFromWorld{ 1.0f };
  vtkTexture* Source = nullptr;
  vtkMTimeType Time = 0;
  SkyDecoding Decoding;
};
}
