// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGITemporalAccumulation
 * @brief   averages what few samples found over the frames in which a surface is seen
 *
 * A surface is found in the frame before by the camera's and its prop's motion, and its mean goes on
 * unless depth, normal or prop say that something else was seen there. What changes is held near what
 * the neighbourhood now shows; a changed light begins anew.
 */
#ifndef vtkGITemporalAccumulation_h
#define vtkGITemporalAccumulation_h

#include "vtkGITemporalAccumulationParameters.h"

#include <memory> // for its memory of views

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
