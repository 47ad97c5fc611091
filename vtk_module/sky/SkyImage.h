// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An equirectangular image of radiance as VTK's image-based lighting reads it, in sky coordinates: x toward
 * EnvironmentRight, y up, and z = x cross y. Longitude 0 is x, in the middle of the image.
 */
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace penumbra
{
/// Unit vector to an elevation and azimuth in degrees. Azimuth 90 is x. Compass bearings increase from -z toward x;
/// other azimuths increase from z toward x.
glm::dvec3 SkyDirection(double elevation, double azimuth, bool compass);

/// A bright rectangle or disc.
struct SkyBox
{
  double Elevation = 0.0; ///< degrees, as all angles
  double Azimuth = 0.0;
  double Width = 0.0; ///< between the sides of the pyramid with its apex at the viewer
  double Height = 0.0;
  double Radius = 0.0; ///< of a disc; 0 for a rectangle
  double Softness = 0.0;
  glm::dvec3 Radiance{ 0.0 };

  /// In steradians, of the box with hard edges.
  double SolidAngle() const;
};

class SkyImage
{
public:
  explicit SkyImage(int width);
  /// With the pixels of an image of three floats.
  SkyImage(int width, const float* pixels);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const std::vector<glm::vec3>& GetPixels() const { return this->Pixels; } ///< lowest row first

  /// Set each pixel to the radiance from its direction. Called by several threads.
  void Fill(const std::function<glm::dvec3(const glm::dvec3& direction)>& radiance);

  /// Set the lower half.
  void FillBelow(const glm::vec3& radiance);

  /// Add a box. Its power is exactly its radiance times its solid angle, however small or soft it is.
  void Add(const SkyBox& box, bool compass);

  glm::dvec3 At(const glm::dvec3& direction) const; ///< of the nearest pixel
  glm::dvec3 Irradiance(const glm::dvec3& normal) const;

private:
  glm::dvec3 Direction(double x, double y) const; ///< coordinates in pixels
  double SolidAngle(int y) const;                 ///< of a pixel in a row

  int Width;
  int Height;
  std::vector<glm::vec3> Pixels;
};
}
