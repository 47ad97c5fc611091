// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIDDGI
 * @brief   diffuse indirect light by probes that rays update every frame
 *
 * A grid of probes fills the bounds of the visible props. In every update each probe traces some rays,
 * whose ends are lit by the lights and by the probes themselves, so that light bounces without end; what
 * the rays find is blended into two small maps of the probe, of light and of distances. A surface takes
 * its indirect light from the eight probes around it, as far as they see it. Lights, geometry, colours and
 * time steps may change at any time. Lights stay as they are: ambient occlusion takes no share of them
 * where indirect light is known.
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

  /// Where a bake no longer fits, see vtkGILightmap::LiveFallback and vtkGISHProbes::LiveFallback.
  bool StandsIn(const penumbra::LightingPlan& plan) override;
  int GetRequiredFrames() override;
  bool IsFinished(vtkRenderer* renderer) override;

  /**
   * Of a renderer's last frame: the probes of each grid along x, y and z; updates since the scene changed or a grid
   * moved; where the outermost probes of one of the grids stand, as VTK's bounds, empty where there is no such grid.
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
