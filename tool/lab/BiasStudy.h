// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The whole experiment: every kind of bias swept in one view, with pictures of the worst places.
#ifndef penumbra_tool_BiasStudy_h
#define penumbra_tool_BiasStudy_h

#include "common/Reporter.h"
#include "image/Picture.h"
#include "lab/BiasSweep.h"

#include <string>
#include <utility>
#include <vector>

namespace penumbra::tool
{
class ShadowBench;

struct BiasStudyOptions
{
  std::vector<std::string> Kinds; ///< "constant"; the others are 0 meanwhile
  std::vector<double> Biases;     ///< texels, rising
  int Resolution = 0;             ///< of the map; 0 chooses one whose texels the picture shows
  BiasLimits Limits;
};

/// The same part of every picture, in pixels from the upper left corner.
struct Crop
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;
};

struct BiasStudy
{
  BiasStudyOptions Options;
  int Resolution = 0;
  double TexelWidth = 0; ///< world units; of a positional light, in the middle of what it reaches
  double PixelWidth = 0; ///< texels
  double FilterRadius = 0;
  double Lost = 0; ///< share of the true shadow that no map of this resolution shows
  std::size_t LitPixels = 0, DarkPixels = 0, ContactPoints = 0, OutlinePoints = 0;
  std::vector<std::pair<std::string, double>> Defaults; ///< every kind's
  BiasErrors AtDefaults;
  std::vector<BiasSweep> Sweeps;

  Picture Overview;            ///< with rays
  Picture OverviewAtDefaults;  ///< with maps
  Crop AcnePlace;              ///< where acne is worst, of all kinds together
  std::vector<Crop> GapPlaces; ///< of every sweep: where most light leaks in
  struct Views
  {
    Picture AcnePlace;
    Picture GapPlace;
  };
  std::vector<std::vector<Views>> Strips; ///< of every sweep, every sample
};

/// That part of the picture.
Picture Cut(const Picture& picture, const Crop& crop);

BiasStudy StudyBias(ShadowBench& bench, const BiasStudyOptions& options, Reporter& reporter);

/// Measures masks of the bench's view, which TraceTruth() draws; the map's biases stay as they are.
BiasJudge JudgeShadows(ShadowBench& bench);

/// Makes the map as coarse as its texels need to be to show in the bench's view.
void FitResolution(ShadowBench& bench);

/// The greatest power of two, at most the technique's resolution, at which a texel is at least two
/// pixels wide: what a picture does not resolve can be neither seen nor measured in it.
int ChooseResolution(double pixelWidth, int resolution);
}

#endif
