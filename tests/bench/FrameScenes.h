// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The same scene in windows of its own, one for each way of drawing that is compared.
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
/// One way of drawing. Prepare configures a new renderer; Touch makes what must be redrawn stale.
struct Variant
{
  std::string Name;
  std::function<void(vtkRenderer*)> Prepare;
  std::function<void(vtkActor*)> Touch;
};

/// Stock VTK and the pass: nothing, ambient occlusion of 32 samples, one redrawn shadow map of
/// 1024 x 1024.
std::vector<Variant> Variants();

/// The presets; and each technique by itself, as "+name", and, where the balanced preset holds it, that
/// preset without it, as "-name".
std::vector<Variant> TechniqueVariants();

/// What each technique adds to the preset off, and takes from the balanced one.
std::vector<Cost> Costs(const std::vector<Variant>& variants);

/// The head of an MRI volume as a surface, from NIfTI. Throws std::runtime_error where
/// the file is missing.
vtkSmartPointer<vtkPolyData> ReadHead(const std::string& file, double isovalue);

class Stage
{
public:
  Stage(const Variant& variant, vtkPolyData* surface, int width, int height);
  ~Stage();

  /// Draw the next view of an orbit and wait for the GPU; seconds it took.
  double DrawFrame();

private:
  Variant Way;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkActor> Actor;
};
}
