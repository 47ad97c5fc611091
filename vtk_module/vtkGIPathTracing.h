// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIPathTracing
 * @brief   the ground truth: every term of the rendering equation, one path a pixel and frame
 *
 * While nothing changes each frame adds a path through every pixel, and the window shows the mean.
 * Surfaces are traced against (GetLeftOut() of the notes tells which are not); lines, points, text
 * and volumes are drawn by VTK. Translucent surfaces let rays pass by chance, as their opacity says.
 */
#ifndef vtkGIPathTracing_h
#define vtkGIPathTracing_h

#include "vtkGIPathTracingParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIPathTracing : public vtkGIPathTracingParameters
{
public:
  static vtkGIPathTracing* New();
  vtkTypeMacro(vtkGIPathTracing, vtkGIPathTracingParameters);

  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIPathTracing();
  ~vtkGIPathTracing() override;

private:
  vtkGIPathTracing(const vtkGIPathTracing&) = delete;
  void operator=(const vtkGIPathTracing&) = delete;
};

#endif
