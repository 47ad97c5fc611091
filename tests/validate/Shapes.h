// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Shapes of scenes with known light.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>

namespace validate
{
using Shape = vtkSmartPointer<vtkPolyData>;

/// A quadrilateral. Corners are counter-clockwise as seen from the front.
Shape Quad(const std::array<std::array<double, 3>, 4>& corners);
/// An axis-parallel rectangle at height z, front up.
Shape Floor(double xMin, double xMax, double yMin, double yMax, double z);
/// An axis-parallel rectangle at height z, front down.
Shape Ceiling(double xMin, double xMax, double yMin, double yMax, double z);
/// A box with its fronts outside, rotated about the z axis. angle: in degrees.
Shape Box(const std::array<double, 3>& low, const std::array<double, 3>& high, double angle = 0.0);
/// A regular polygon of 720 corners around the z axis. Its area is 0.0013 % smaller than the circle's.
Shape Disc(double radius, double z, bool frontUp);
/// A smooth sphere or a zone of it. Latitudes are counted from the top, in degrees.
Shape Sphere(double radius, double z, double fromLatitude = 0.0, double toLatitude = 180.0);
Shape Torus(double ringRadius, double tubeRadius);
}
