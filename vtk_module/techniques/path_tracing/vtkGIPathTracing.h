// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIPathTracing
 * @brief   the reference: the full rendering equation, with one path per pixel and frame
 *
 * While nothing changes, each frame adds a path through every pixel, and the window shows the mean.
 * Paths see surfaces; the notes of vtkGIPass tell how many props they do not see. VTK draws lines,
 * points, text and volumes. Translucent surfaces let rays pass at random, with a probability that
 * follows from their opacity.
 */
#ifndef vtkGIPathTracing_h
#define vtkGIPathTracing_h

#include "vtkGIPathTracingParameters.h"
#include "vtkSmartPointer.h" // for pending progress
#include "vtkWeakPointer.h"  // for its renderer

#include <utility> // for pairs of these
#include <vector>  // for several renderers

class vtkGIPass;
class vtkImageData;

namespace penumbra
{
struct PathTracer;
}

class VTKRENDERINGGI_EXPORT vtkGIPathTracing : public vtkGIPathTracingParameters
{
public:
  static vtkGIPathTracing* New();
  vtkTypeMacro(vtkGIPathTracing, vtkGIPathTracingParameters);

  ///@{
  /**
   * GetSamplesTaken(): number of paths traced through every pixel of a renderer since its scene changed.
   * GetRelativeError(): standard error of their mean over the whole picture, relative to its mean luminance;
   * infinite until the first estimate. It overestimates, because the samples are stratified and the estimate
   * treats them as independent.
   */
  int GetSamplesTaken(vtkRenderer* renderer);
  double GetRelativeError(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * Save what was traced so far, and resume from it later, even in another process. The image has the window's
   * size, the arrays of four floats that GetBuffer() of the pass returns under the names path-tracing.shown,
   * .encoded, .albedo, .normal and .unlit, and the field array "samples". GetProgress() returns false if nothing was
   * traced yet. SetProgress() takes effect with the next frame, which continues as if it had traced those samples
   * itself; the scene, the view and the parameters must be the same. It returns false and changes nothing if
   * arrays are missing.
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
  vtkSmartPointer<vtkImageData> TakePendingProgress(vtkRenderer* renderer);
  /// Have denoising filter the light of the paths.
  void AddSignal(
    penumbra::FrameBuilder& frame, const penumbra::PathTracer& tracer, Progress& progress);

  /// Progress from which the next frames of renderers resume.
  std::vector<std::pair<vtkWeakPointer<vtkRenderer>, vtkSmartPointer<vtkImageData>>>
    PendingProgress;

  vtkGIPathTracing(const vtkGIPathTracing&) = delete;
  void operator=(const vtkGIPathTracing&) = delete;
};

#endif
