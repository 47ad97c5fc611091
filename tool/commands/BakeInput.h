// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The scene of a bake.
#pragma once

#include "commands/OptionGroup.h"
#include "commands/RenderOptions.h"
#include "console/Console.h"
#include "scene/build/SceneBuilder.h"

namespace penumbra::tool
{
/// Throws a Failure if a file has the wrong extension, for the given reason, or cannot be written.
void RequireBakeFile(const std::string& path, const char* extension, const char* reason);

struct BakeInput
{
  RenderOptions Options;
  std::vector<std::string> Excluded; ///< names of objects
  Scene Description;
  BuiltScene Built;

  void DeclareExclusions(OptionGroup& group);
  void Build(Console& console);
  /// Builds the scene in a window of a few pixels, and opens it, for bakes on the GPU.
  vtkSmartPointer<vtkRenderWindow> BuildInWindow(Console& console);
};
}
