// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A window that path traces small scenes with the public classes, and returns their pictures as numbers.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkActor;
class vtkGIPass;
class vtkGIPathTracing;
class vtkHeadlessRenderWindow;
class vtkPolyData;
class vtkRenderer;

namespace validate
{
using Vec3 = std::array<double, 3>;

struct Material
{
  enum Kind
  {
    Phong,
    Pbr,
    Unlit
  };
  Kind Model = Phong;
  Vec3 Color = { { 0.0, 0.0, 0.0 } }; ///< diffuse reflectance or base colour; unlit: radiance
  double Emission = 0.0;              ///< radiance; Phong only
  double Specular = 0.0;              ///< Phong
  double Power = 1.0;                 ///< Phong
  double Metallic = 0.0;              ///< PBR
  double Roughness = 0.5;             ///< PBR
};
Material Matte(double reflectance, double emission = 0.0);
Material Painted(const Vec3& reflectance);
Material Shiny(double diffuse, double specular, double power);
Material Physical(double color, double metallic, double roughness);

/// Result of a sequence of still frames.
struct Film
{
  int Width = 0;
  int Height = 0;
  int Samples = 0;               ///< per pixel
  std::vector<float> Color;      ///< mean linear radiance, three values per pixel, bottom row first
  std::vector<double> Luminance; ///< luminance of the mean
  std::vector<double> SquareMean; ///< mean of the samples' squared luminance
  std::vector<double> Coverage;   ///< fraction of the pixel that surfaces cover
  double Seconds = 0.0;           ///< time of all frames after the first, which compiles shaders
};

class Studio
{
public:
  Studio();
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  std::string Description() const;

  /// Start an empty black scene without light, with eight reflections and both strategies.
  void Clear(int width, int height);
  void Add(vtkPolyData* shape, const Material& material, bool culled = false);
  /// Add uniform light from all directions: a cube around the scene that shows its plain colour.
  void AddEnvironment(double radiance, double halfSize);
  /// Set uniform light from all directions by an environment texture, with a background of the same value.
  void SetEnvironmentTexture(double radiance);

  /// Set a parallel projection, as a square picture of the given half width. Surfaces nearer to the eye than `nearest`
  /// are not visible, but cast shadows and emit light.
  void LookParallel(
    const Vec3& eye, const Vec3& target, const Vec3& up, double half, double nearest);
  void Look(const Vec3& eye, const Vec3& target, double angle);

  void SetBounces(int bounces);
  void SetStrategy(const char* strategy);
  /// Set a folder whose shaders replace the built-in ones; "" for the folder of the environment variable.
  void SetShaders(const std::string& folder);

  /// Trace a number of paths per pixel, starting from scratch.
  Film Trace(int samples);
  /// Called during Trace() with the finished fraction.
  std::function<void(double)> OnProgress;

private:
  vtkSmartPointer<vtkHeadlessRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGIPathTracing* Tracer;
  std::string Shaders; ///< folder of the environment variable
};

/// Write a PNG file for inspection, in sRGB.
void SavePng(const Film& film, const std::string& file);
}
