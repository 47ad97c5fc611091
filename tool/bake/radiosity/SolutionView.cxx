// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/Sampling.h"
#include "bake/radiosity/SolutionFile.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

namespace penumbra::radiosity
{
namespace
{
/// Rays through points of the picture, with coordinates from -1 to 1.
class CameraRays
{
public:
  CameraRays(vtkCamera* camera, double aspect)
  {
    vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
    for (int i = 0; i < 16; ++i)
    {
      this->ToWorld[i % 4][i / 4] = matrix->GetData()[i];
    }
    this->ToWorld = glm::inverse(this->ToWorld);
  }

  std::pair<Point, Point> Through(double x, double y) const
  {
    const Point near = this->Place(x, y, -1.0);
    return { near, glm::normalize(this->Place(x, y, 0.0) - near) };
  }

private:
  Point Place(double x, double y, double z) const
  {
    const glm::dvec4 place = this->ToWorld * glm::dvec4(x, y, z, 1.0);
    return Point(place) / place.w;
  }
  glm::dmat4 ToWorld{ 1.0 };
};

Color RadianceOf(const Solution& solution, const PatchRays::Hit& hit, bool flat)
{
  const Element& element = solution.Elements[hit.Element];
  if (flat)
  {
    return solution.Radiosity[hit.Element] / glm::pi<double>();
  }
  // On the back, the second and third corners are swapped.
  const bool back = hit.Element % 2 != 0;
  const double weights[3] = { 1.0 - hit.U - hit.V, back ? hit.V : hit.U, back ? hit.U : hit.V };
  Color irradiance(0.0);
  for (int k = 0; k < 3; ++k)
  {
    irradiance +=
      weights[k] * solution.Points.Irradiance[solution.Points.OfElement[hit.Element][k]];
  }
  return (element.Emission + element.Reflectance * irradiance) / glm::pi<double>();
}

Color BackgroundAt(vtkRenderer* renderer, double height)
{
  const double* bottom = renderer->GetBackground();
  const double* top = renderer->GetGradientBackground() ? renderer->GetBackground2() : bottom;
  return glm::mix(Color(bottom[0], bottom[1], bottom[2]), Color(top[0], top[1], top[2]), height);
}
}

tool::Picture DrawSolution(const Solution& solution, vtkRenderer* renderer, int width, int height,
  int samples, bool flat, const tool::Progress& advance)
{
  tool::Picture picture(width, height, 3);
  const PatchRays rays(solution.Elements);
  const CameraRays camera(renderer->GetActiveCamera(), double(width) / height);
  const int side = GridSide(samples);
  const auto draw = [&](std::size_t row) {
    for (int x = 0; x < width; ++x)
    {
      Color sum(0.0);
      for (int i = 0; i < side * side; ++i)
      {
        const double u = (x + (i % side + 0.5) / side) / width;
        const double v = 1.0 - (double(row) + (i / side + 0.5) / side) / height;
        const auto [from, direction] = camera.Through(2.0 * u - 1.0, 2.0 * v - 1.0);
        const auto hit = rays.Nearest(from, Point(0.0), direction);
        sum += hit.Element == PatchRays::Nothing ? BackgroundAt(renderer, v)
                                                 : RadianceOf(solution, hit, flat);
      }
      for (int k = 0; k < 3; ++k)
      {
        picture.Pixel(row * width + x)[k] = static_cast<float>(sum[k] / (side * side));
      }
    }
  };
  tool::ForEach(static_cast<std::size_t>(height), draw, advance);
  return picture;
}
}
