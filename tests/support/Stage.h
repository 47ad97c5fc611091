// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A headless window and functions that build a scene in it.
#pragma once

#include "vtkGIPass.h"
#include "vtkHeadlessRenderWindow.h"

#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkMapper;
class vtkPolyData;

namespace penumbra_test
{
class Stage
{
public:
  /// Create a window without multisampling, with one renderer that has a plain background.
  explicit Stage(int backend = vtkHeadlessRenderWindow::AUTO);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  vtkSmartPointer<vtkHeadlessRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer; ///< the first one

  /// Add another renderer to the window.
  vtkRenderer* AddRenderer();

  /// Show geometry in a colour other than white, with a polydata mapper unless another one is given.
  vtkActor* Add(vtkAlgorithm* source);
  vtkActor* Add(vtkPolyData* data);
  vtkActor* Add(vtkMapper* mapper);

  /// Look at the whole scene from the right and slightly from above.
  static void LookAround(vtkRenderer* renderer);

  /// Set a new pass on every renderer. Returns the passes.
  std::vector<vtkSmartPointer<vtkGIPass>> SetPasses();
};

/// Whether a context can be created with the given backend, by default the one that the environment chooses.
bool HasBackend(int backend = vtkHeadlessRenderWindow::AUTO);

/// Whether Mesa draws on the CPU. Renders the window.
bool IsSoftware(vtkHeadlessRenderWindow* window);
}
