// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Offscreen windows.
#pragma once

#include <nlohmann/json.hpp>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace penumbra::tool
{
/// An offscreen window with a backend: "egl", "osmesa", "x11" or "auto". Throws a Failure for another name, or if x11 has
/// no display.
vtkSmartPointer<vtkRenderWindow> MakeWindow(const std::string& backend);

/// Creates the window's context. Returns its "backend", "vendor", "renderer" and "version". Throws a Failure with the
/// reason if there is no context.
nlohmann::ordered_json OpenWindow(vtkRenderWindow* window);
}
