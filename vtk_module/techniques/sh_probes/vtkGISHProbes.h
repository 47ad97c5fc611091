// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGISHProbes
 * @brief   diffuse indirect light from baked probes, for static and moving props
 *
 * vtkGIProbeBaker, or `penumbra bake probes`, gathers the light that arrives at a grid of probes. A surface takes
 * its indirect light from those of the eight probes around it that see it. Baked props, lights and the environment
 * must not change. If one does, the pass says so in its notes, and the probes give no light until the scene is again
 * as it was baked. Props that were not baked may be added, moved and removed.
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
   * The difference between the baked scene and the renderer's last frame, such as "light 1 moved"; "" if there is none.
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
