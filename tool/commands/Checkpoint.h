// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A file (.vti) with the state of path tracing, to resume after an interruption.
#pragma once

#include "commands/Commands.h"

#include <string>
#include <vector>

class vtkGIPass;
class vtkGIPathTracing;
class vtkRenderer;

namespace penumbra::tool
{
/// A hash of a text (such as options) and of the content of files. Files that cannot be read count as empty.
std::string Fingerprint(const std::string& text, const std::vector<std::string>& files);

class Checkpoint
{
public:
  /// identity: a description of the picture. A file with another one is rejected.
  Checkpoint(std::string path, std::string identity, vtkGIPass* pass, vtkRenderer* renderer);

  /// Resumes from the file if it exists. Returns its number of samples. Throws a Failure if it is not a checkpoint, or of
  /// another picture.
  int Resume();

  /// Writes the file; an existing file stays intact until the new one is complete. Throws a Failure.
  void Save();
  void SaveIfDue();

private:
  std::string Path;
  std::string Identity;
  vtkGIPass* Pass;
  vtkRenderer* Renderer;
  vtkGIPathTracing* Tracer;
  Clock::time_point Saved = Clock::now();
};
}
