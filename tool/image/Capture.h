// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Pictures of a rendered window.
#pragma once

#include "image/Picture.h"

#include <functional>

class vtkGIPass;
class vtkRenderWindow;
class vtkRenderer;

namespace penumbra::tool
{
/// What the window shows, in display values; with alpha if asked for.
Picture CaptureWindow(vtkRenderWindow* window, bool alpha);

/// The pass's linear radiance of opaque surfaces and background. Where translucent props, volumes or
/// annotations change the picture, what the window shows replaces it; to find these pixels the scene is
/// drawn once more without them, by calling render. A traced picture stays as it is: translucent props
/// are in it, volumes and annotations are not. Throws a Failure where the pass kept no radiance.
Picture CaptureRadiance(
  vtkGIPass* pass, vtkRenderer* renderer, bool alpha, const std::function<void()>& render);

/// Appends what the path tracer knows of the surfaces in the picture: their albedo, normal (in the
/// world), distance along the line of sight, the number of samples, and the standard error of each
/// pixel's luminance. Nothing without it.
void AppendSurfaceLayers(vtkGIPass* pass, vtkRenderer* renderer, Picture& picture);
}
