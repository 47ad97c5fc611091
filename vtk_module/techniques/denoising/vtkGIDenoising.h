// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIDenoising
 * @brief   filters the noise of few rays
 *
 * Averages what rays found at neighbouring pixels of the same surface, by its depth and normal. The reach of the filter
 * falls with the number of frames in each pixel's mean (vtkGITemporalAccumulation), to nothing. Filters the light of
 * vtkGIRayTracedLight and that of vtkGIPathTracing, without the colours of the surfaces, so that textures stay sharp, the
 * shadows of vtkGIRayTracedShadows as far as their penumbrae, and the reflections of vtkGIScreenSpaceReflections as far as
 * their lobes.
 */
#ifndef vtkGIDenoising_h
#define vtkGIDenoising_h

#include "vtkGIDenoisingParameters.h"

namespace penumbra
{
class GuideNetwork;
}

class VTKRENDERINGGI_EXPORT vtkGIDenoising : public vtkGIDenoisingParameters
{
public:
  static vtkGIDenoising* New();
  vtkTypeMacro(vtkGIDenoising, vtkGIDenoisingParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIDenoising();
  ~vtkGIDenoising() override;

private:
  void AddFilters(penumbra::FrameBuilder& frame);
  /// The network of the frame's view; nullptr if none is wanted, or it does not run.
  penumbra::GuideNetwork* FindNetwork(penumbra::FrameBuilder& frame);

  vtkGIDenoising(const vtkGIDenoising&) = delete;
  void operator=(const vtkGIDenoising&) = delete;
};

#endif
