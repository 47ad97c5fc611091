// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The light that a renderer's environment texture sends from all directions, and a table to pick
 * directions from in proportion to it (rays/sky.glsl).
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
/// Means over cells of equal solid angles: even in longitude, and in the sine of latitude from the lowest row on.
struct EqualCells
{
  int Columns = 0;
  int Rows = 0;
  std::vector<glm::vec4> Values;

  /// Of a picture over longitude and latitude.
  static EqualCells Of(
    const std::vector<glm::vec4>& pixels, int width, int height, int columns, int rows);
  /// Of these, for a multiple of both numbers.
  EqualCells Coarser(int columns, int rows) const;
};

class RaySky
{
public:
  /// Follow the renderer: its texture where it lights with images, else no light at all.
  void Update(vtkRenderer* renderer);
  bool Shines() const { return this->Radiance != nullptr; }

  void AddTo(Arguments& arguments) const;
  /// What each of so many rays that are spread evenly stands for.
  void AddCells(Arguments& arguments, int rays);
  void Release();

private:
  std::unique_ptr<Texture> Radiance; ///< layers: for matter; for highlights where that differs
  std::unique_ptr<Texture> Table;
  std::unique_ptr<Texture> Means; ///< over cells, for so many rays
  int MeansRays = 0;
  EqualCells Fine;
  glm::ivec2 Cells{ 0 };
  glm::mat3 ToSky{ 1.0f };
  vtkTexture* Source = nullptr;
  vtkMTimeType Time = 0;
  SkyDecoding Decoding;
};

/// A table of chances for a picture of the whole sphere (longitude, latitude): a row of cumulative
/// chances for each band of latitude, and one more for the bands. Each row begins with 0 and ends
/// with 1; a tenth of all directions is picked evenly. Pharr, Jakob and Humphreys 2016, Physically
/// Based Rendering, section 14.2.4. columns, rows: of the table's cells.
std::vector<float> MakeSkyTable(
  const std::vector<glm::vec4>& pixels, int width, int height, int columns, int rows);
}
