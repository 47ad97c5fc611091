// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A window in which small scenes are path traced through the public classes, and their pictures
// read back as numbers.
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

/// What a sequence of still frames came to.
struct Film
{
  int Width = 0;
  int Height = 0;
  int Samples = 0;                ///< per pixel
  std::vector<float> Color;       ///< mean linear radiance, three values a pixel, bottom row first
  std::vector<double> Luminance;  ///< of the mean
  std::vector<double> SquareMean; ///< mean of the samples' squared luminance
  std::vector<double> Coverage;   ///< part of the pixel in which the eye met a surface
  double Seconds = 0.0;           ///< of all frames after the first, which compiles shaders
};

class Studio
{
public:
  Studio();
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  std::string Description() const;

  /// An empty black scene without lamps; eight reflections and every strategy; an own picture size.
  void Clear(int width, int height);
  void Add(vtkPolyData* shape, const Material& material, bool culled = false);
  /// Uniform light from everywhere: a cube that shows its colour, the scene in its middle.
  void AddEnvironment(double radiance, double halfSize);
  /// The same by an environment texture, before a background of that value.
  void SetEnvironmentTexture(double radiance);

  /// Parallel rays from `eye` on, a square picture of the given half width. What lies nearer to the
  /// eye than `nearest` is not seen, though it casts shadows and shines.
  void LookParallel(
    const Vec3& eye, const Vec3& target, const Vec3& up, double half, double nearest);
  void Look(const Vec3& eye, const Vec3& target, double angle);

  void SetBounces(int bounces);
  void SetStrategy(const char* strategy);
  /// A folder of shaders in place of the built-in ones of the same name; "" for the environment's.
  void SetShaders(const std::string& folder);

  /// Trace so many paths through every pixel, from the first one on.
  Film Trace(int samples);
  /// Called with the part that is done of a Trace().
  std::function<void(double)> OnProgress;

private:
  vtkSmartPointer<vtkHeadlessRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGIPathTracing* Tracer;
  std::string Shaders; ///< the environment's folder
};

/// A PNG file for people, with sRGB's curve.
void SavePng(const Film& film, const std::string& file);
}
