// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Builds a renderer from a described scene.
#pragma once

#include "common/Reporter.h"
#include "scene/model/SceneModel.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <map>

namespace penumbra::tool
{
struct BuiltScene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  std::map<vtkProp*, std::string> Names; ///< names of objects
  vtkIdType Triangles = 0;
  vtkIdType Balls = 0;
  bool DepthPeeling = false; ///< whether the scene is translucent and peeling enabled
};

/// Reads data and builds the scene. Throws a Failure for what cannot be drawn.
BuiltScene BuildScene(const Scene& scene, vtkIdType maximumTriangles, Reporter& reporter);

/// Sets a background, and colours for the texts before it that can be read.
void SetBackground(const Background& background, vtkRenderer* renderer);

/// Gives the scale of colours a dark or a bright text, depending on the renderer's background.
void SetTextColors(vtkRenderer* renderer);

/// Adds the scene's renderer to the window, and sets its size and what the scene needs. Call before the first frame.
void ConfigureWindow(const Scene& scene, const BuiltScene& built, vtkRenderWindow* window);
}
