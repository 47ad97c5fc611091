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
/// What rendering may cost before it is refused.
struct SceneLimits
{
  vtkIdType Triangles = 10000000;
};

struct BuiltScene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  std::map<vtkProp*, std::string> Names; ///< of the objects that have one
  vtkIdType Triangles = 0;
  vtkIdType Balls = 0;
  bool DepthPeeling = false; ///< the scene is translucent and peeling is not switched off
};

/// Reads and builds everything; throws a Failure for what cannot be drawn.
BuiltScene BuildScene(const Scene& scene, const SceneLimits& limits, Reporter& reporter);

/// Gives the window the scene's renderer, its size and the settings they need. Call before the first
/// picture.
void ConfigureWindow(const Scene& scene, const BuiltScene& built, vtkRenderWindow* window);
}
