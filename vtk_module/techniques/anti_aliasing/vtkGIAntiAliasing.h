// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIAntiAliasing
 * @brief   smooth edges: filtered on the first frame, averaged over still ones
 *
 * While nothing changes each frame is drawn with another shift of a part of a pixel, and the
 * window shows the average: it converges to supersampling, noise of stochastic techniques
 * included. A changed scene starts anew with a filter of its edges. Annotations, translucent props
 * and volumes are drawn over the result, unshifted and unfiltered.
 */
#ifndef vtkGIAntiAliasing_h
#define vtkGIAntiAliasing_h

#include "vtkGIAntiAliasingParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIAntiAliasing : public vtkGIAntiAliasingParameters
{
public:
  static vtkGIAntiAliasing* New();
  vtkTypeMacro(vtkGIAntiAliasing, vtkGIAntiAliasingParameters);

  void Contribute(penumbra::FrameBuilder& frame) override;
  bool ChangesLight() override { return false; }

protected:
  vtkGIAntiAliasing();
  ~vtkGIAntiAliasing() override;

private:
  vtkGIAntiAliasing(const vtkGIAntiAliasing&) = delete;
  void operator=(const vtkGIAntiAliasing&) = delete;
};

#endif
