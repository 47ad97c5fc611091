// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Measures of how far a picture is from a reference.
#pragma once

#include "image/Picture.h"

#include <limits>

namespace penumbra::tool
{
struct MetricOptions
{
  double Epsilon = 1e-2; ///< added to the squared reference in relMSE
  double Tolerance = 2;  ///< in 255ths: a pixel differs where a channel is further off
  /// Pixels where either picture is brighter in a channel are left out with their neighbours: lamps in
  /// view, which would outweigh what they light.
  double MaskAbove = std::numeric_limits<double>::infinity();
};

struct Metrics
{
  double RelativeMse = 0;  ///< mean of (a - b)^2 / (b^2 + epsilon) over channels and pixels
  double SignedMean = 0;   ///< mean of luminance a - luminance b: bias, not noise
  double Percentile99 = 0; ///< of the pixels' greatest channel difference
  double Maximum = 0;
  double Ssim = 1;           ///< mean structural similarity of the luminance
  double FractionOver = 0;   ///< pixels further off than the tolerance
  std::size_t NonFinite = 0; ///< pixels with NaN or infinity in either picture, left out
  std::size_t Masked = 0;    ///< pixels left out as too bright
};

/// Measures picture a against reference b; both must have the same size.
Metrics Measure(const Picture& a, const Picture& b, const MetricOptions& options);

/// The absolute difference times a gain, in colour.
Picture DifferencePicture(const Picture& a, const Picture& b, double gain);
}
