// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/BakeOptions.h"

#include "common/Failure.h"
#include "common/Names.h"
#include "common/Windows.h"

#include <filesystem>

#include <unistd.h>

namespace penumbra::tool
{
void RequireBakeFile(const std::string& path, const char* ending, const char* what)
{
  if (std::filesystem::path(path).extension() != ending)
  {
    FailUsage("'{}' does not end in {}: {}", path, ending, what);
  }
  const auto folder = std::filesystem::path(path).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK) != 0 ||
    std::filesystem::is_directory(path))
  {
    Fail("'{}' cannot be written: choose another file with -o, in a folder you may write to", path);
  }
}

void HideObjects(const BuiltScene& built, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    bool found = false;
    std::vector<std::string> known;
    for (const auto& [prop, called] : built.Names)
    {
      known.push_back(called);
      if (called == name)
      {
        prop->VisibilityOff();
        found = true;
      }
    }
    if (!found)
    {
      FailUsage("{}", UnknownName("object", name, "", known));
    }
  }
}

void OpenBakeWindow(
  const Scene& scene, const BuiltScene& built, vtkRenderWindow* window, Console& console)
{
  ConfigureWindow(scene, built, window);
  constexpr int side = 16; // nothing is drawn in it
  window->SetSize(side, side);
  window->SetMultiSamples(0);
  Step step(console, "opening an OpenGL window");
  OpenWindow(window);
}
}
