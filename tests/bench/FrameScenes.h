// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The same scene in several windows, one for each way of drawing that is compared.
 */
#pragma once

#include "Report.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

namespace bench
{
/// A way of drawing. Prepare configures a new renderer. Touch is called before each frame, to modify what must be
/// redrawn.
struct Variant
{
  std::string Name;
  std::function<void(vtkRenderer*)> Prepare;
  std::function<void(vtkActor*)> Touch;
};

/// Stock VTK and the pass, each alone, with ambient occlusion of 32 samples, and with a shadow map of 1024 x 1024 that
/// is redrawn in each frame.
std::vector<Variant> Variants();

/// The presets; each technique by itself, as "+name"; and the preset balanced without each of its techniques, as
/// "-name".
std::vector<Variant> TechniqueVariants();

/// Cost of each technique: by itself, and in the preset balanced.
std::vector<Cost> Costs(const std::vector<Variant>& variants);

/// Isosurface of a NIfTI volume. Throws std::runtime_error if the file is missing.
vtkSmartPointer<vtkPolyData> ReadHead(const std::string& file, double isovalue);

class Stage
{
public:
  Stage(const Variant& variant, vtkPolyData* surface, int width, int height);
  ~Stage();

  /// Draw the next view of an orbit and wait for the GPU. Returns the seconds that this took.
  double DrawFrame();

  /// The same without turning the camera.
  double RepeatFrame();

private:
  Variant Drawing;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkActor> Actor;
};
}
