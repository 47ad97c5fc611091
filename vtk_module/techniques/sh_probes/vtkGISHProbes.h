// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGISHProbes
 * @brief   diffuse indirect light from probes baked beforehand, for what stands and what moves among them
 *
 * vtkGIProbeBaker, or `penumbra bake probes`, gathers the light that arrives at a grid of probes. A surface takes
 * its indirect light from the eight around it, as far as they see it. What was baked must stay as it was: once a
 * prop, a lamp or the environment of the bake changes, the pass says so in its notes, and the probes give no light
 * until all is back. Props that the bake does not know may come, go and move.
 */
#ifndef vtkGISHProbes_h
#define vtkGISHProbes_h

#include "vtkGISHProbesParameters.h"

#include <memory> // for the state
#include <string> // for text

class vtkImageData;
class vtkRenderer;

class VTKRENDERINGGI_EXPORT vtkGISHProbes : public vtkGISHProbesParameters
{
public:
  static vtkGISHProbes* New();
  vtkTypeMacro(vtkGISHProbes, vtkGISHProbesParameters);

  ///@{
  /**
   * A baked field, of vtkGIProbeBaker or read from its file.
   */
  const char* GetBakeFormat() override { return "penumbra probes"; }
  bool SetBake(vtkImageData* field) override;
  const char* GetBakeError() override;
  bool HasBake();
  ///@}

  /**
   * What differs from the baked scene in the renderer's last frame, as in "light 1 moved"; "" where it fits.
   */
  std::string GetMismatch(vtkRenderer* renderer);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGISHProbes();
  ~vtkGISHProbes() override;

private:
  vtkGISHProbes(const vtkGISHProbes&) = delete;
  void operator=(const vtkGISHProbes&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
