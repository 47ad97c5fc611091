// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The few shapes that scenes with known answers are made of.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>

namespace validate
{
using Shape = vtkSmartPointer<vtkPolyData>;

/// Corners counter-clockwise as its front sees them.
Shape Quad(const std::array<std::array<double, 3>, 4>& corners);
/// At a height, axis-parallel, its front up.
Shape Floor(double xMin, double xMax, double yMin, double yMax, double z);
/// The same, its front down.
Shape Ceiling(double xMin, double xMax, double yMin, double yMax, double z);
/// Flat faces, their fronts outside.
Shape Box(const std::array<double, 3>& low, const std::array<double, 3>& high, double turn = 0.0);
/// A polygon of 720 corners about the z axis, 0.0013 % smaller than its circle.
Shape Disc(double radius, double z, bool frontUp);
/// Smooth; latitudes from the top, in degrees.
Shape Sphere(double radius, double z, double fromLatitude = 0.0, double toLatitude = 180.0);
Shape Torus(double ringRadius, double tubeRadius);
}
