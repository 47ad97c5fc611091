// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIAntiAliasing
 * @brief   smooth edges: an edge filter on the first frame, then the average of jittered frames
 *
 * While nothing changes, each frame is drawn with a different subpixel jitter, and the window shows the
 * average. It converges to supersampling, and the noise of stochastic techniques averages out with it.
 * After a change it starts again from the edge filter. Annotations, translucent props and volumes are
 * drawn over the result, without jitter or filter.
 */
#ifndef vtkGIAntiAliasing_h
#define vtkGIAntiAliasing_h

#include "vtkGIAntiAliasingParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIAntiAliasing : public vtkGIAntiAliasingParameters
{
public:
  static vtkGIAntiAliasing* New();
  vtkTypeMacro(vtkGIAntiAliasing, vtkGIAntiAliasingParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;
  bool ChangesLight() override { return false; }

protected:
  vtkGIAntiAliasing();
  ~vtkGIAntiAliasing() override;

private:
  int ModeIn(penumbra::FrameBuilder& frame) const;
  vtkGIAntiAliasing(const vtkGIAntiAliasing&) = delete;
  void operator=(const vtkGIAntiAliasing&) = delete;
};

#endif
