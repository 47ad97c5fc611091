// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The baked probes of one render view: read from a file, or baked from what the view shows.
 */
#pragma once

#include <string>

class vtkGISHProbes;
class vtkRenderer;

namespace penumbra
{
class BakedProbes
{
public:
  /// Where the probes are, or are written to once they are baked; "" keeps what is baked in memory alone.
  void SetFile(const std::string& path);

  /// What a bake takes: probes at most, and paths from each.
  void SetProbes(int probes) { this->Probes = probes; }
  void SetSamples(int samples) { this->Samples = samples; }

  /// Gives the technique what the file holds, unless it has it. A file that cannot be used is told to the user.
  void Update(vtkGISHProbes* technique);

  /// Bakes what a renderer shows, and writes the file if one is named.
  void Bake(vtkGISHProbes* technique, vtkRenderer* renderer);

  /// Tells the user why they cannot be had, in a sentence; "" where all is well.
  void Tell(const std::string& problem);

  /// What was told last.
  const std::string& GetProblem() const { return this->Problem; }

private:
  std::string File;
  std::string Problem;
  bool FileIsNew = false;
  int Probes = 1024;
  int Samples = 256;
};
}
