// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Baking: from a renderer to a lightmap.
#pragma once

#include "bake/lightmap/LightmapFile.h"

#include "common/Reporter.h"

#include <functional>
#include <map>
#include <optional>

class vtkProp;
class vtkRenderer;

namespace penumbra::lightmap
{
struct BakeSettings
{
  double TexelSize = 0.0; ///< world units; 0: a 128th of the surfaces' diagonal
  int LargestSide = 4096; ///< of the atlas, texels
  int Samples = 256;      ///< paths from each texel, a multiple of Rounds
  int Bounces = 64;
  bool Directional = false;
  bool Lamps = false; ///< what arrives straight from lamps, too
  bool Denoise = true;
  bool CloseSeams = true;
  std::string Output; ///< where the file will be: what is done so far is kept beside it
  bool Anew = false;  ///< keep nothing of an earlier bake or of one that was broken off
  std::map<vtkProp*, std::string> Names; ///< of props

  static constexpr int Rounds = 16; ///< that the samples are taken in
};

struct BakeResult
{
  Lightmap Map;
  double TexelSize = 0.0;
  std::size_t Charts = 0, Tiles = 0, Texels = 0;
  std::size_t DarkSides = 0; ///< of charts: no light reaches them, so that they have no tile
  std::size_t Buried = 0;    ///< texels within solids, filled from beside
  std::size_t KeptTiles = 0; ///< whose light is the earlier bake's
  double Resumed = 0.0;      ///< share of the work that an earlier call had done
  double SeamStep = 0.0;     ///< the greatest, of the light there
  double OpenSeamStep = 0.0; ///< before seams were closed
};

/// Bakes the renderer's scene; its window must be open. Throws a Failure.
BakeResult BakeLightmap(
  vtkRenderer* renderer, const BakeSettings& settings, tool::Reporter& reporter);
}
