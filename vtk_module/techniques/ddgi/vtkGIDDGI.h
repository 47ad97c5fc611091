// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIDDGI
 * @brief   diffuse indirect light from probes that rays update every frame
 *
 * A grid of probes fills the bounds of the visible props. In every update each probe traces some rays.
 * The surfaces they hit are lit by the lights and by the probes themselves, which adds one bounce per
 * update. The results are blended into two small maps of each probe, one of irradiance and one of
 * distances. A surface takes its indirect light from those of the eight probes around it that see it.
 * Lights, geometry, colours and time steps may change at any time. Lights keep their full strength:
 * where indirect light is available, ambient occlusion does not spread a share of it.
 */
#ifndef vtkGIDDGI_h
#define vtkGIDDGI_h

#include "vtkGIDDGIParameters.h"

#include <memory> // for the state

class vtkRenderer;

namespace penumbra
{
class LiveField;
}

class VTKRENDERINGGI_EXPORT vtkGIDDGI : public vtkGIDDGIParameters
{
public:
  static vtkGIDDGI* New();
  vtkTypeMacro(vtkGIDDGI, vtkGIDDGIParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

  /// True if a bake no longer fits, see vtkGILightmap::LiveFallback and vtkGISHProbes::LiveFallback.
  bool StandsIn(const penumbra::LightingPlan& plan) override;
  int GetRequiredFrames() override;
  bool IsFinished(vtkRenderer* renderer) override;

  /**
   * State of the probes after a renderer's last frame. GetGrid(): the number of probes of the first grid along x, y and
   * z. GetGridBounds(): the positions of a grid's outermost probes, as VTK's bounds, which are empty if there is no
   * such grid. GetUpdatesDone(): the number of updates since the scene changed or a grid moved.
   */
  void GetGrid(vtkRenderer* renderer, int counts[3]);
  void GetGridBounds(vtkRenderer* renderer, int number, double bounds[6]);
  int GetUpdatesDone(vtkRenderer* renderer);

protected:
  vtkGIDDGI();
  ~vtkGIDDGI() override;

private:
  vtkGIDDGI(const vtkGIDDGI&) = delete;
  void operator=(const vtkGIDDGI&) = delete;

  const penumbra::LiveField* Find(vtkRenderer* renderer) const;
};

#endif
