// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGITemporalAccumulation
 * @brief   averages noisy results over the frames in which a surface is visible
 *
 * Reprojection finds each surface in the previous frame by the motion of the camera and of its prop.
 * History is rejected where depth, normal or prop show a different surface. While anything changes,
 * history is clamped to the pixel's neighbourhood; the mask of a changed light starts from scratch.
 */
#ifndef vtkGITemporalAccumulation_h
#define vtkGITemporalAccumulation_h

#include "vtkGITemporalAccumulationParameters.h"

class VTKRENDERINGGI_EXPORT vtkGITemporalAccumulation : public vtkGITemporalAccumulationParameters
{
public:
  static vtkGITemporalAccumulation* New();
  vtkTypeMacro(vtkGITemporalAccumulation, vtkGITemporalAccumulationParameters);

protected:
  vtkGITemporalAccumulation();
  ~vtkGITemporalAccumulation() override;

  void Contribute(penumbra::FrameBuilder& frame) override;

private:
  vtkGITemporalAccumulation(const vtkGITemporalAccumulation&) = delete;
  void operator=(const vtkGITemporalAccumulation&) = delete;
};

#endif
