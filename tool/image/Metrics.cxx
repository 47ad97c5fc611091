// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Metrics.h"

#include "image/ColorDifference.h"

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
/// For each pixel, whether it or one of its eight neighbours is too bright in either picture.
std::vector<char> TooBright(const Picture& a, const Picture& b, double limit)
{
  std::vector<char> bright(a.PixelCount(), 0);
  for (std::size_t i = 0; i < a.PixelCount() && std::isfinite(limit); ++i)
  {
    bool above = false;
    for (int channel = 0; channel < 3; ++channel)
    {
      above = above || a.Color(i, channel) > limit || b.Color(i, channel) > limit;
    }
    const int x = static_cast<int>(i % a.Width);
    const int y = static_cast<int>(i / a.Width);
    for (int v = std::max(0, y - 1); above && v <= std::min(a.Height - 1, y + 1); ++v)
    {
      for (int u = std::max(0, x - 1); u <= std::min(a.Width - 1, x + 1); ++u)
      {
        bright[static_cast<std::size_t>(v) * a.Width + u] = 1;
      }
    }
  }
  return bright;
}

double Mean(const std::vector<double>& values)
{
  double sum = 0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

/// The value that a share of them do not exceed. Reorders the values.
double Quantile(std::vector<double>& values, double share)
{
  const auto rank =
    values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

Lab LabOf(const Picture& picture, std::size_t pixel)
{
  return LabOfDisplay(picture.Color(pixel, 0), picture.Color(pixel, 1), picture.Color(pixel, 2));
}
}

Metrics Measure(const Picture& a, const Picture& b, const MetricOptions& options)
{
  Metrics metrics;
  std::vector<double> worst, total, hue, flip;
  worst.reserve(a.PixelCount());
  metrics.Flip = Flip(a, b, options.PixelsPerDegree);
  double squares = 0, bias = 0;
  std::size_t over = 0;
  const std::vector<char> masked = TooBright(a, b, options.MaskAbove);
  for (std::size_t i = 0; i < a.PixelCount(); ++i)
  {
    if (masked[i])
    {
      ++metrics.Masked;
      continue;
    }
    double greatest = 0, square = 0;
    for (int channel = 0; channel < 3; ++channel)
    {
      const double reference = b.Color(i, channel);
      const double difference = a.Color(i, channel) - reference;
      square += difference * difference / (reference * reference + options.Epsilon);
      greatest = std::max(greatest, std::abs(difference));
    }
    if (!std::isfinite(square) || !std::isfinite(greatest))
    {
      ++metrics.NonFinite;
      continue;
    }
    squares += square / 3;
    bias += a.Luminance(i) - b.Luminance(i);
    // Half a 255th allows for the rounding of 8-bit files.
    over += greatest > (options.Tolerance + 0.5) / 255 ? 1 : 0;
    worst.push_back(greatest);
    const ColorDifference seen = Ciede2000(LabOf(a, i), LabOf(b, i));
    total.push_back(seen.Total);
    hue.push_back(seen.Hue);
    flip.push_back(metrics.Flip[i]);
  }
  if (worst.empty())
  {
    return metrics;
  }
  const double count = static_cast<double>(worst.size());
  metrics.RelativeMse = squares / count;
  metrics.SignedMean = bias / count;
  metrics.FractionOver = over / count;
  metrics.Maximum = *std::max_element(worst.begin(), worst.end());
  metrics.Percentile99 = Quantile(worst, 0.99);
  metrics.DeltaEMean = Mean(total);
  metrics.DeltaE99 = Quantile(total, 0.99);
  metrics.DeltaHMean = Mean(hue);
  metrics.DeltaH99 = Quantile(hue, 0.99);
  metrics.FlipMean = Mean(flip);
  metrics.Flip95 = Quantile(flip, 0.95);
  metrics.Ssim = StructuralSimilarity(a, b);
  return metrics;
}

Picture GreyPicture(const Plane& plane, int width)
{
  Picture picture(width, static_cast<int>(plane.size()) / width, 3);
  for (std::size_t i = 0; i < plane.size(); ++i)
  {
    std::fill_n(picture.Pixel(i), 3, static_cast<float>(plane[i]));
  }
  return picture;
}

Picture DifferencePicture(const Picture& a, const Picture& b, double gain)
{
  Picture difference(a.Width, a.Height, 3);
  for (std::size_t i = 0; i < a.PixelCount(); ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double value = gain * std::abs(a.Color(i, channel) - b.Color(i, channel));
      difference.Pixel(i)[channel] = std::isfinite(value) ? static_cast<float>(value) : 1.0f;
    }
  }
  return difference;
}
}
