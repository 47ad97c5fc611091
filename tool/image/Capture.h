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
/// The content of the window in display values, optionally with alpha.
Picture CaptureWindow(vtkRenderWindow* window, bool alpha);

/// The pass's linear radiance of opaque surfaces and background. Where translucent props, volumes or annotations change the
/// picture, the content of the window replaces it; redraw is called once without them to find these pixels. A path-traced
/// picture remains unchanged: it includes translucent props, but no volumes or annotations. Throws a Failure if the pass
/// kept no radiance.
Picture CaptureRadiance(
  vtkGIPass* pass, vtkRenderer* renderer, bool alpha, const std::function<void()>& redraw);

/// Appends layers of the path tracer, if it is enabled: albedo, normal (in world coordinates), and depth of the surfaces,
/// the number of samples, and the standard error of each pixel's luminance; if denoising is enabled, the picture before it.
void AppendSurfaceLayers(vtkGIPass* pass, vtkRenderer* renderer, Picture& picture);
}
