// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Tracing that is kept in a file (.vti), so that it can be broken off and gone on with.
#pragma once

#include <chrono>
#include <string>
#include <vector>

class vtkGIPass;
class vtkGIPathTracing;
class vtkRenderer;

namespace penumbra::tool
{
/// Tells inputs apart: a text (such as options) and what is in files. Names of files that cannot be read
/// (an empty name too) count as nothing in them.
std::string Fingerprint(const std::string& text, const std::vector<std::string>& files);

class Checkpoint
{
public:
  /// identity: says what is traced; a file of something else is refused.
  Checkpoint(std::string path, std::string identity, vtkGIPass* pass, vtkRenderer* renderer);

  /// Go on from the file, if it exists. Returns the samples in it. Throws a Failure for a file that is
  /// no checkpoint, or one of another picture.
  int Resume();

  /// Write the file if it is time to, or in any case; a file that is there stays whole until the new
  /// one is. Throws a Failure where it cannot be written.
  void Save(bool inAnyCase);

private:
  [[noreturn]] void Refuse() const;

  std::string Path;
  std::string Identity;
  vtkGIPass* Pass;
  vtkRenderer* Renderer;
  vtkGIPathTracing* Tracer;
  std::chrono::steady_clock::time_point Saved = std::chrono::steady_clock::now();
};
}
