// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sky/SkyImage.h"

#include "base/Parallel.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// A box is sampled at least this often across.
constexpr double SamplesAcross = 12.0;
constexpr int MostSamples = 64; // across a pixel

/// Falls from 1 to 0 where the edge of the box is, at 1.
double Edge(double place, double softness)
{
  return softness > 0.0 ? 1.0 - glm::smoothstep(1.0 - softness, 1.0 + softness, place)
                        : (place <= 1.0 ? 1.0 : 0.0);
}

/// The share of a box's radiance in a direction.
class Profile
{
public:
  Profile(const SkyBox& box, bool compass)
    : Softness(box.Softness)
    , Radius(glm::radians(box.Radius))
    , Extent(std::tan(0.5 * glm::radians(box.Width)), std::tan(0.5 * glm::radians(box.Height)))
    , Middle(SkyDirection(box.Elevation, box.Azimuth, compass))
    , Side(SkyDirection(0.0, box.Azimuth + 90.0, compass))
    , Up(glm::cross(this->Middle, this->Side))
  {
    // The farthest point from the middle that a soft edge reaches.
    const double reach = 1.0 + this->Softness;
    this->Reach = this->Radius > 0.0 ? std::min(this->Radius * reach, glm::pi<double>())
                                     : std::atan(reach * glm::length(this->Extent));
  }

  bool IsNear(const glm::dvec3& direction, double margin) const
  {
    return this->AngleTo(direction) <= this->Reach + margin;
  }

  double At(const glm::dvec3& direction) const
  {
    if (this->Radius > 0.0)
    {
      return Edge(this->AngleTo(direction) / this->Radius, this->Softness);
    }
    const double depth = glm::dot(direction, this->Middle);
    return depth <= 0.0
      ? 0.0
      : Edge(std::abs(glm::dot(direction, this->Side)) / depth / this->Extent.x, this->Softness) *
        Edge(std::abs(glm::dot(direction, this->Up)) / depth / this->Extent.y, this->Softness);
  }

private:
  double AngleTo(const glm::dvec3& direction) const
  {
    return 2.0 * std::asin(std::min(1.0, 0.5 * glm::distance(direction, this->Middle)));
  }

  double Softness;
  double Radius;
  double Reach = 0.0;
  glm::dvec2 Extent;
  glm::dvec3 Middle, Side, Up;
};
}

glm::dvec3 SkyDirection(double elevation, double azimuth, bool compass)
{
  const double e = glm::radians(elevation);
  const double a = glm::radians(azimuth);
  return { std::cos(e) * std::sin(a), std::sin(e),
    (compass ? -1.0 : 1.0) * std::cos(e) * std::cos(a) };
}

double SkyBox::SolidAngle() const
{
  return this->Radius > 0.0 ? 2.0 * glm::pi<double>() * (1.0 - std::cos(glm::radians(this->Radius)))
                            : 4.0 *
      std::asin(
        std::sin(0.5 * glm::radians(this->Width)) * std::sin(0.5 * glm::radians(this->Height)));
}

SkyImage::SkyImage(int width)
  : Width(width)
  , Height(width / 2)
  , Pixels(static_cast<std::size_t>(this->Width) * this->Height, glm::vec3(0.0f))
{
}

SkyImage::SkyImage(int width, const float* pixels)
  : SkyImage(width)
{
  std::copy_n(pixels, 3 * this->Pixels.size(), &this->Pixels.front()[0]);
}

void SkyImage::FillBelow(const glm::vec3& radiance)
{
  std::fill_n(this->Pixels.begin(), this->Pixels.size() / 2, radiance);
}

glm::dvec3 SkyImage::Direction(double x, double y) const
{
  const double latitude = (y / this->Height - 0.5) * glm::pi<double>();
  const double longitude = (x / this->Width - 0.5) * 2.0 * glm::pi<double>();
  return { std::cos(latitude) * std::cos(longitude), std::sin(latitude),
    std::cos(latitude) * std::sin(longitude) };
}

double SkyImage::SolidAngle(int y) const
{
  const double step = glm::pi<double>() / this->Height;
  return (std::sin((y + 1) * step - glm::half_pi<double>()) -
           std::sin(y * step - glm::half_pi<double>())) *
    2.0 * glm::pi<double>() / this->Width;
}

void SkyImage::Fill(const std::function<glm::dvec3(const glm::dvec3& direction)>& radiance)
{
  constexpr std::size_t grain = 2048; // a direction through the atmosphere takes microseconds
  ParallelFor(
    this->Pixels.size(),
    [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto x = static_cast<double>(i % static_cast<std::size_t>(this->Width));
        const auto y = static_cast<double>(i / static_cast<std::size_t>(this->Width));
        this->Pixels[i] = glm::vec3(radiance(this->Direction(x + 0.5, y + 0.5)));
      }
    },
    grain);
}

void SkyImage::Add(const SkyBox& box, bool compass)
{
  const Profile profile(box, compass);
  const double pixel = 180.0 / this->Height;
  const double across = box.Radius > 0.0 ? 2.0 * box.Radius : std::min(box.Width, box.Height);
  const int samples =
    std::clamp(static_cast<int>(std::ceil(SamplesAcross * pixel / across)), 3, MostSamples);
  std::vector<double> shares(this->Pixels.size(), 0.0);
  double total = 0.0;
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      if (!profile.IsNear(this->Direction(x + 0.5, y + 0.5), glm::radians(pixel)))
      {
        continue;
      }
      double sum = 0.0;
      for (int i = 0; i < samples * samples; ++i)
      {
        sum += profile.At(this->Direction(
          x + (i % samples + 0.5) / samples, y + (double(i / samples) + 0.5) / samples));
      }
      double& share = shares[static_cast<std::size_t>(y) * this->Width + x];
      share = sum / (samples * samples);
      total += share * this->SolidAngle(y);
    }
  }
  const double gain = total > 0.0 ? box.SolidAngle() / total : 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    this->Pixels[i] += glm::vec3(gain * shares[i] * box.Radiance);
  }
}

glm::dvec3 SkyImage::At(const glm::dvec3& direction) const
{
  const double latitude = std::asin(std::clamp(direction.y, -1.0, 1.0));
  const double longitude = std::atan2(direction.z, direction.x);
  const auto x = static_cast<int>((longitude / (2.0 * glm::pi<double>()) + 0.5) * this->Width);
  const auto y = static_cast<int>((latitude / glm::pi<double>() + 0.5) * this->Height);
  return this->Pixels[static_cast<std::size_t>(std::min(y, this->Height - 1)) * this->Width +
    std::min(x, this->Width - 1)];
}

glm::dvec3 SkyImage::Irradiance(const glm::dvec3& normal) const
{
  glm::dvec3 sum(0.0);
  for (int y = 0; y < this->Height; ++y)
  {
    const double solidAngle = this->SolidAngle(y);
    for (int x = 0; x < this->Width; ++x)
    {
      const double facing = glm::dot(this->Direction(x + 0.5, y + 0.5), normal);
      sum += std::max(0.0, facing) * solidAngle *
        glm::dvec3(this->Pixels[static_cast<std::size_t>(y) * this->Width + x]);
    }
  }
  return sum;
}
}
