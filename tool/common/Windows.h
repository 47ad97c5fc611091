// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Offscreen windows by backend.
#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace penumbra::tool
{
/// What draws a window's pictures.
struct GraphicsInfo
{
  std::string Backend;
  std::string Vendor;
  std::string Renderer;
  std::string Version;
};

/// An offscreen window of the backend: "egl", "osmesa", "x11" or "auto". Throws a Failure for another
/// name, or where there is no display for x11.
vtkSmartPointer<vtkRenderWindow> MakeWindow(const std::string& backend);

/// Makes the window's context and says what it is; throws a Failure that gives the reason where there
/// is none.
GraphicsInfo OpenWindow(vtkRenderWindow* window);
}
