// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Framing.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
constexpr double Border = 1.1; // width of the picture relative to the scene: margins of about 5 %

/// The camera's axes: to the right, up, and from the scene to the camera.
struct Axes
{
  Vec3 Right, Up, Front;
};

Axes ViewAxes(const Vec3& front, const Vec3& up)
{
  Axes axes;
  axes.Front = front;
  vtkMath::Normalize(axes.Front.data());
  vtkMath::Cross(up.data(), axes.Front.data(), axes.Right.data());
  if (vtkMath::Normalize(axes.Right.data()) < 1e-9)
  {
    // The view is along the up axis: any perpendicular direction is suitable.
    vtkMath::Perpendiculars(axes.Front.data(), axes.Right.data(), axes.Up.data(), 0);
  }
  vtkMath::Cross(axes.Front.data(), axes.Right.data(), axes.Up.data());
  return axes;
}

/// Rotates the default view about the up axis, then raises it.
Vec3 ViewDirection(const Camera& camera, const DefaultView& view)
{
  const Axes axes = ViewAxes(view.Front, view.Up);
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(camera.Azimuth.value_or(view.Azimuth), view.Up.data());
  turn->RotateWXYZ(-camera.Elevation.value_or(view.Elevation), axes.Right.data());
  Vec3 direction;
  turn->TransformVector(axes.Front.data(), direction.data());
  return direction;
}

/// The default view with another axis up, if the camera says so and its position does not.
DefaultView Stand(const Camera& camera, DefaultView view)
{
  if (camera.ViewUp && !camera.Position)
  {
    view.Up = *camera.ViewUp;
    vtkMath::Normalize(view.Up.data());
    if (std::abs(vtkMath::Dot(view.Up.data(), view.Front.data())) > 0.7)
    {
      // What stands along y faces z, and the other way round what stands along z faces -y.
      const bool alongY = std::abs(view.Up[1]) > 0.7;
      view.Front = alongY ? Vec3{ 0, 0, view.Up[1] } : Vec3{ 0, -view.Up[2], 0 };
    }
  }
  return view;
}

/// Maxima of sideways + slope * depth on both sides. They are the two planes of the frustum that touch the scene and meet
/// at the camera.
struct Extent
{
  double Low = -1e300, High = -1e300;
  void Add(double sideways, double depth, double slope)
  {
    this->High = std::max(this->High, sideways + depth * slope);
    this->Low = std::max(this->Low, -sideways + depth * slope);
  }
  double Middle() const { return (this->High - this->Low) / 2; }
  double Half() const { return (this->High + this->Low) / 2; }
};

struct Fit
{
  Vec3 Center = { 0, 0, 0 }; ///< on the view axis, at the depth of the scene's centre
  double Distance = 1;
  double ParallelScale = 1;
};

Fit FitPoints(
  const std::vector<Vec3>& points, const Axes& axes, double slopeY, double aspect, bool parallel)
{
  Fit fit;
  if (points.empty())
  {
    return fit;
  }
  const double slopeX = slopeY * aspect;
  Extent x, y, depth;
  for (const Vec3& p : points)
  {
    const double forward = vtkMath::Dot(p.data(), axes.Front.data());
    x.Add(vtkMath::Dot(p.data(), axes.Right.data()), forward, parallel ? 0 : slopeX);
    y.Add(vtkMath::Dot(p.data(), axes.Up.data()), forward, parallel ? 0 : slopeY);
    depth.Add(forward, 0, 0);
  }
  const double size = std::max({ x.Half(), y.Half(), depth.Half(), 1e-12 });
  fit.ParallelScale = Border * std::max({ y.Half(), x.Half() / aspect, 1e-6 * size });
  const double front =
    parallel ? depth.High + 4 * size : std::max(x.Half() / slopeX, y.Half() / slopeY);
  fit.Distance = front - depth.Middle();
  for (int i = 0; i < 3; ++i)
  {
    fit.Center[i] =
      x.Middle() * axes.Right[i] + y.Middle() * axes.Up[i] + depth.Middle() * axes.Front[i];
  }
  return fit;
}
}

void AddFramedPoints(
  vtkPolyData* geometry, vtkMatrix4x4* transform, double margin, std::vector<Vec3>& points)
{
  // A subset is enough for the silhouette of a mesh.
  constexpr vtkIdType most = 50000;
  const vtkIdType count = geometry->GetNumberOfPoints();
  const vtkIdType stride = std::max<vtkIdType>(1, count / most);
  for (vtkIdType i = 0; i < count; i += stride)
  {
    double p[4] = { 0, 0, 0, 1 };
    geometry->GetPoint(i, p);
    transform->MultiplyPoint(p, p);
    for (int axis = 0; axis < (margin > 0 ? 3 : 1); ++axis)
    {
      for (double side : { -margin, margin })
      {
        Vec3 point = { p[0], p[1], p[2] };
        point[axis] += side;
        points.push_back(point);
      }
    }
  }
}

void SetCamera(const Camera& described, const DefaultView& usual, const std::vector<Vec3>& points,
  double aspect, vtkRenderer* renderer)
{
  const DefaultView view = Stand(described, usual);
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vec3 up = described.ViewUp.value_or(view.Up);
  Vec3 direction = ViewDirection(described, view);
  const double slope = std::tan(vtkMath::RadiansFromDegrees(described.ViewAngle) / 2);
  Fit fit = FitPoints(points, ViewAxes(direction, up), slope / Border, aspect, described.Parallel);
  const Vec3 focal = described.FocalPoint.value_or(fit.Center);
  Vec3 position;
  for (int i = 0; i < 3; ++i)
  {
    position[i] =
      focal[i] + direction[i] * fit.Distance / (described.Parallel ? 1 : described.Zoom);
  }
  if (described.Position)
  {
    position = *described.Position;
    vtkMath::Subtract(position.data(), focal.data(), direction.data());
  }
  Axes axes = ViewAxes(direction, up);
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focal.data());
  camera->SetViewUp(axes.Up.data());
  camera->SetViewAngle(described.ViewAngle);
  camera->SetParallelProjection(described.Parallel);
  camera->SetParallelScale(described.ParallelScale.value_or(fit.ParallelScale) / described.Zoom);
  if (described.Position && !described.Parallel)
  {
    camera->Zoom(described.Zoom);
  }
  camera->Roll(described.Roll);
  renderer->ResetCameraClippingRange();
}
}
