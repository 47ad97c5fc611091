// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Radiance of a renderer's environment texture, and a table for importance sampling of its directions
 * (rays/sky.glsl).
 */
#pragma once

#include "gpu/GLObjects.h"
#include "gpu/ShaderLibrary.h"
#include "rays/SkyPictures.h"

#include <glm/glm.hpp>

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkRenderer;
class vtkTexture;

namespace penumbra
{
/// Means over cells of equal solid angle: a regular grid over longitude and the sine of latitude, lowest row first.
struct EqualCells
{
  int Columns = 0;
  int Rows = 0;
  std::vector<glm::vec4> Values;

  /// Means of an equirectangular image.
  static EqualCells Of(
    const std::vector<glm::vec4>& pixels, int width, int height, int columns, int rows);
  /// Means over larger cells. Both numbers of cells must divide the current ones.
  EqualCells Coarser(int columns, int rows) const;
};

class RaySky
{
public:
  /// Update from the renderer: its texture if it uses image-based lighting, else no light.
  void Update(vtkRenderer* renderer);
  bool Shines() const { return this->Radiance != nullptr; }

  void AddTo(Arguments& arguments) const;
  /// Add mean radiances over the solid angles of a number of evenly distributed rays.
  void AddCells(Arguments& arguments, int rays);
  void Release();

private:
  std::unique_ptr<Texture> Radiance; ///< layers: diffuse; highlights, if different
  std::unique_ptr<Texture> Table;
  std::unique_ptr<Texture> Means; ///< means over cells, for MeansRays
  int MeansRays = 0;
  EqualCells Fine;
  glm::ivec2 Cells{ 0 };
  glm::mat3 ToSky{ 1.0f };
  vtkTexture* Source = nullptr;
  vtkMTimeType Time = 0;
  SkyDecoding Decoding;
};

/// Irradiance, divided by pi, of a surface with this normal in world coordinates that nothing hides from the environment;
/// 0 if the renderer does not use its light. Reads the whole image.
glm::dvec3 OpenSkyLight(vtkRenderer* renderer, const glm::dvec3& normal);

/// Sampling table of an equirectangular image: a row of cumulative
/// probabilities for each band of latitude, and another row for the bands. Each row begins with 0 and ends
/// with 1. A tenth of all directions is sampled uniformly. Pharr, Jakob and Humphreys 2016, Physically
/// Based Rendering, section 14.2.4. columns, rows: numbers of cells in the table.
std::vector<float> MakeSkyTable(
  const std::vector<glm::vec4>& pixels, int width, int height, int columns, int rows);
}
