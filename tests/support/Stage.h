// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A headless window with a scene in it, built in a few words.
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
  /// The window has no multisampling; the first renderer has a plain background.
  explicit Stage(int backend = vtkHeadlessRenderWindow::AUTO);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  vtkSmartPointer<vtkHeadlessRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer; ///< the first one

  /// Another renderer of the window.
  vtkRenderer* AddRenderer();

  /// Show geometry with a polydata mapper, in a colour of its own.
  vtkActor* Add(vtkAlgorithm* source);
  vtkActor* Add(vtkPolyData* data);
  vtkActor* Add(vtkMapper* mapper);

  /// Look at everything from a little above and from the right. Cases that place a renderer's
  /// camera themselves leave this alone.
  static void LookAround(vtkRenderer* renderer);

  /// Put a pass on every renderer, and say which.
  std::vector<vtkSmartPointer<vtkGIPass>> SetPasses();
};

/// True where the backend that the environment chooses (or the given one) has a context here.
bool HasBackend(int backend = vtkHeadlessRenderWindow::AUTO);
}
