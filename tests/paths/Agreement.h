// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Comparison of VTK's rasterizer with rays.
#pragma once

#include "Picture.h"
#include "Stage.h"

namespace penumbra_test
{
/// Agreement of a path-traced picture of direct light with the rasterizer's.
struct Agreement
{
  double AtCenters = 0.0;     ///< share of all pixels within 3/255, with rays through the centres
  double AwayFromEdges = 0.0; ///< share of pixels away from edges within 2/255, 16 rays per pixel
  double Considered = 0.0;    ///< share of pixels that are away from edges
  double Shown = 0.0;         ///< share of pixels that are not background
  std::string Notes;          ///< the pass's notes on the path-traced frame
  Picture Raster;
  Picture Rays;
};

/// Light the stage from the camera, so that no visible surface is in shadow, with a long focal length. Call it when the
/// scene is complete.
void LightFromCamera(Stage& stage);

/// Draw the stage with rays and with the rasterizer. Rays come first, before the mappers have drawn anything.
Agreement CompareWithRaster(Stage& stage);

/// Expect that rays see what VTK draws. Through the centres of pixels, one pixel in a thousand may differ: there an
/// edge runs through the centre. In the mean of 16 rays per pixel and away from edges, one in a hundred may differ:
/// there an edge of little contrast runs. The tolerances allow for 8-bit colours that are rounded twice, in the capture
/// and in the window.
void ExpectAgreement(Stage& stage, const std::string& name);
}
