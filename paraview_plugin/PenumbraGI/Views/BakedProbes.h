// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The baked probes of one render view, which are read from a file or baked from the view's scene.
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
  /// Set the file from which probes are read, and to which baked probes are written. "" keeps baked probes in memory
  /// only.
  void SetFile(const std::string& path);

  /// Parameters of a bake: maximum number of probes, and number of paths from each.
  void SetProbes(int probes) { this->Probes = probes; }
  void SetSamples(int samples) { this->Samples = samples; }

  /// Give the file's probes to the technique if the file changed. Reports a file that cannot be used.
  void Update(vtkGISHProbes* technique);

  /// Bake a renderer's scene, and write the file if one is set.
  void Bake(vtkGISHProbes* technique, vtkRenderer* renderer);

  /// Show the user a problem in one sentence; "" if there is none.
  void Report(const std::string& problem);

  /// The last problem, or "".
  const std::string& GetProblem() const { return this->Problem; }

private:
  std::string File;
  std::string Problem;
  bool FileChanged = false;
  int Probes = 1024;
  int Samples = 256;
};
}
