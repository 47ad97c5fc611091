// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What the commands below penumbra bake have in common.
#pragma once

#include "commands/Command.h"

#include "scene/build/SceneBuilder.h"

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace penumbra::tool
{
/// Fails where the file has another ending, for what it is (".vti", "the lightmap is written as a VTK image"), or
/// cannot be written.
void RequireBakeFile(const std::string& path, const char* ending, const char* what);

/// Hides the objects of these names. Fails where there is none of a name.
void HideObjects(const BuiltScene& built, const std::vector<std::string>& names);

/// The scene in a window of a few pixels, whose context is there: for bakes on the GPU.
void OpenBakeWindow(
  const Scene& scene, const BuiltScene& built, vtkRenderWindow* window, Console& console);
}
