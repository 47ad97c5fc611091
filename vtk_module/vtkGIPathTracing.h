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

#include <cmath> // for HUGE_VAL
#include <map>   // for the progress of each renderer

class VTKRENDERINGGI_EXPORT vtkGIPathTracing : public vtkGIPathTracingParameters
{
public:
  static vtkGIPathTracing* New();
  vtkTypeMacro(vtkGIPathTracing, vtkGIPathTracingParameters);

  ///@{
  /**
   * Paths traced through every pixel of a renderer since its scene changed, and the standard error
   * of their mean over the whole picture, relative to its mean luminance; infinite before it is
   * first estimated. The samples are spread more evenly than chance would, so that the true error is
   * smaller.
   */
  int GetSamplesTaken(vtkRenderer* renderer);
  double GetRelativeError(vtkRenderer* renderer);
  ///@}

  int GetRequiredFrames() override { return this->Samples; }
  bool IsFinished(vtkRenderer* renderer) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIPathTracing();
  ~vtkGIPathTracing() override;

private:
  struct Progress
  {
    int Samples = 0;
    double Error = HUGE_VAL;
  };
  std::map<vtkRenderer*, Progress> Renderers;

  vtkGIPathTracing(const vtkGIPathTracing&) = delete;
  void operator=(const vtkGIPathTracing&) = delete;
};

#endif
