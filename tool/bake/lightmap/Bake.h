// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Baking a renderer's scene to a lightmap.
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
  double TexelSize = 0.0; ///< world units; 0: 1/128 of the surfaces' diagonal
  int LargestSide = 4096; ///< maximum width and height of the atlas, in texels
  int Samples = 256;      ///< paths per texel, a multiple of Rounds
  int Bounces = 64;
  double MaximumAlbedo = 1.0; ///< see vtkGILightGatherer
  bool EnergyCompensation = false;
  bool Directional = false;
  bool Direct = false; ///< also direct light
  bool Denoise = true;
  bool CloseSeams = true;
  std::string Output;                    ///< file to write; progress is stored beside it
  bool FromScratch = false;              ///< ignore an earlier or interrupted bake
  std::map<vtkProp*, std::string> Names; ///< of props

  static constexpr int Rounds = 16; ///< number of rounds of samples
};

struct BakeResult
{
  Lightmap Map;
  double TexelSize = 0.0;
  std::size_t Charts = 0, Tiles = 0, Texels = 0;
  std::size_t DarkSides = 0; ///< sides of charts without a tile, because no light reaches them
  std::size_t Buried = 0;    ///< texels within solids, filled from their neighbours
  std::size_t KeptTiles = 0; ///< tiles with light of the earlier bake
  double Resumed = 0.0;      ///< share of the work done by an interrupted bake
  double SeamStep = 0.0;     ///< greatest step across seams, relative to the light there
  double OpenSeamStep = 0.0; ///< before closing seams
};

/// Bakes the scene of a renderer whose window is open. Throws a Failure.
BakeResult BakeLightmap(
  vtkRenderer* renderer, const BakeSettings& settings, tool::Reporter& reporter);
}
