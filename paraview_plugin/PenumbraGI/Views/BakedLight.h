// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked light of one technique in one render view: read from a file, or probes baked from the view's scene.
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
  /// Set the file that the bake is read from, and that Bake() writes; "" keeps new bakes in memory only.
  void SetFile(const std::string& path);

  /// Load the file into the technique if the file has changed since. Reports a file that cannot be used.
  void Update(vtkGITechnique* technique);

  /// Bake probes in a renderer's scene, and write the file if one is set. probes: maximum number of probes; samples:
  /// number of paths from each.
  void Bake(vtkGISHProbes* technique, vtkRenderer* renderer, int probes, int samples);

  /// Report to the user, in one sentence, why there is no baked light; "" if all is well.
  void Report(const std::string& problem);

  /// The last report.
  const std::string& GetProblem() const { return this->Problem; }

private:
  std::string File;
  std::string Problem;
  bool FileIsNew = false;
};
}
