// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes seen by VTK's rasterizer and by rays.
#pragma once

#include "Picture.h"
#include "Stage.h"

namespace penumbra_test
{
/// How far a path-traced picture of direct light only is from the rasterizer's.
struct Agreement
{
  double AtCenters = 0.0;  ///< share of all pixels within 3/255, rays through the pixels' centres
  double Away = 0.0;       ///< share within 2/255 of those away from edges, 16 rays a pixel
  double Considered = 0.0; ///< share of pixels that are away from edges
  double Shown = 0.0;      ///< share of pixels that are not background
  std::string Notes;       ///< the pass's, of the path-traced frame
  Picture Raster;
  Picture Rays;
};

/// Light the stage from where it is seen, so that nothing that is seen lies in shadow, and look
/// through a long lens. Call when the scene is complete.
void LightFromTheEye(Stage& stage);

/// Draw the stage both ways: the rays first, before the mappers have drawn anything.
Agreement Compare(Stage& stage);

/// Compare(), and require that rays see what VTK draws: through the centres of all pixels but one in
/// a thousand, where the rasterizer and a ray decide differently on an edge that runs through the
/// centre; and in the mean of 16 rays a pixel, where no edge is near, for all but one in a hundred,
/// which are those that an edge of little contrast crosses. The tolerances are of 8-bit colours that
/// were rounded twice on the way, in the capture and in the window.
void ExpectAgreement(Stage& stage, const std::string& name);
}
