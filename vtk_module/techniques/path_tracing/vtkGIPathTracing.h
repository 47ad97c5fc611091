// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIPathTracing
 * @brief   the ground truth: every term of the rendering equation, one path a pixel and frame
 *
 * While nothing changes each frame adds a path through every pixel, and the window shows the mean.
 * Surfaces are traced against (the notes of vtkGIPass count those that are not); lines, points, text
 * and volumes are drawn by VTK. Translucent surfaces let rays pass by chance, as their opacity says.
 */
#ifndef vtkGIPathTracing_h
#define vtkGIPathTracing_h

#include "vtkGIPathTracingParameters.h"
#include "vtkSmartPointer.h" // for what is to be gone on from
#include "vtkWeakPointer.h"  // for its renderer

#include <utility> // for the two
#include <vector>  // for several renderers

class vtkGIPass;
class vtkImageData;

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

  ///@{
  /**
   * What was traced of a renderer so far, to be gone on from later, in another program if need be: an
   * image of the window's size with the arrays of four floats that GetBuffer() of the pass returns
   * under the names path-tracing.shown, .encoded, .albedo and .normal, and the field array "samples".
   * GetProgress() returns false where nothing was traced. SetProgress() takes effect with the next
   * frame, which goes on as if it had traced those samples itself; the scene, the view and the
   * parameters must be the same. It returns false, leaving all as it is, where arrays are missing.
   */
  bool GetProgress(vtkGIPass* pass, vtkRenderer* renderer, vtkImageData* image);
  bool SetProgress(vtkRenderer* renderer, vtkImageData* image);
  ///@}

  int GetRequiredFrames() override { return this->Samples; }
  bool IsFinished(vtkRenderer* renderer) override;
  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIPathTracing();
  ~vtkGIPathTracing() override;

private:
  struct Progress;
  const Progress* Find(vtkRenderer* renderer) const;
  bool IsFinished(const Progress& progress) const;
  vtkSmartPointer<vtkImageData> TakeUp(vtkRenderer* renderer);

  /// What renderers' next frames go on from.
  std::vector<std::pair<vtkWeakPointer<vtkRenderer>, vtkSmartPointer<vtkImageData>>> ToTakeUp;

  vtkGIPathTracing(const vtkGIPathTracing&) = delete;
  void operator=(const vtkGIPathTracing&) = delete;
};

#endif
