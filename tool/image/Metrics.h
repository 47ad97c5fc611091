// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Differences between a picture and a reference.
#pragma once

#include "image/Flip.h"
#include "image/Picture.h"

#include <limits>

namespace penumbra::tool
{
struct MetricOptions
{
  double Epsilon = 1e-2; ///< added to the squared reference in relMSE
  double Tolerance = 2;  ///< in 255ths: a pixel is counted if any channel differs by more
  /// Pixels where a channel of either picture is brighter are left out with their neighbours. Visible lights would outweigh
  /// everything else.
  double MaskAbove = std::numeric_limits<double>::infinity();
  double PixelsPerDegree = DefaultPixelsPerDegree; ///< of FLIP
};

struct Metrics
{
  double RelativeMse = 0;  ///< mean of (a - b)^2 / (b^2 + epsilon) over channels and pixels
  double SignedMean = 0;   ///< mean of luminance a - luminance b, which is bias, not noise
  double Percentile99 = 0; ///< of the pixels' greatest difference in any channel
  double Maximum = 0;
  /// Perceived differences of the values taken as display values (image/ColorDifference.h).
  double DeltaEMean = 0, DeltaE99 = 0; ///< CIEDE2000: mean and 99th percentile
  double DeltaHMean = 0, DeltaH99 = 0; ///< its part of hue
  double Ssim = 1;                     ///< mean structural similarity of the luminance
  double FlipMean = 0, Flip95 = 0;     ///< FLIP: mean and 95th percentile (image/Flip.h)
  Plane Flip;                          ///< of all pixels
  double FractionOver = 0;             ///< fraction of pixels that exceed the tolerance
  std::size_t NonFinite = 0;           ///< pixels with NaN or infinity in either picture, left out
  std::size_t Masked = 0;              ///< pixels left out as too bright
};

/// Measures picture a against reference b; both must have the same size.
Metrics Measure(const Picture& a, const Picture& b, const MetricOptions& options);

/// The absolute difference times a gain, in colour.
Picture DifferencePicture(const Picture& a, const Picture& b, double gain);

/// A plane as a picture in grey.
Picture GreyPicture(const Plane& plane, int width);

/// Mean SSIM of the luminance, taken as display values with a range of 1. Wang, Bovik, Sheikh and Simoncelli 2004, Image
/// Quality Assessment: From Error Visibility to Structural Similarity.
double StructuralSimilarity(const Picture& a, const Picture& b);
}
