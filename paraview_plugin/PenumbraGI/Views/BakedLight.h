// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked light of one technique in one render view: read from a file, or probes baked from what the view shows.
 */
#pragma once

#include <string>

class vtkGISHProbes;
class vtkGITechnique;
class vtkRenderer;

namespace penumbra
{
class BakedLight
{
public:
  /// Where the bake is, or is written to once it is baked; "" keeps what is baked in memory alone.
  void SetFile(const std::string& path);

  /// Gives the technique what the file holds, unless it has it. A file that cannot be used is told to the user.
  void Update(vtkGITechnique* technique);

  /// Bakes what a renderer shows, and writes the file if one is named. probes: at most; samples: paths from each.
  void Bake(vtkGISHProbes* technique, vtkRenderer* renderer, int probes, int samples);

  /// Tells the user why light cannot be had, in a sentence; "" where all is well.
  void Tell(const std::string& problem);

  /// What was told last.
  const std::string& GetProblem() const { return this->Problem; }

private:
  std::string File;
  std::string Problem;
  bool FileIsNew = false;
};
}
