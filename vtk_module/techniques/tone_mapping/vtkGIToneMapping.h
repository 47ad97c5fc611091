// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIToneMapping
 * @brief   exposure, and a curve from radiance to the display
 *
 * The curve compresses what is brighter than the display can show, instead of cutting it off. It is applied to lit
 * surfaces and volumes: by the rasterizer and the path tracer alike, on linear radiance averaged over still frames.
 * Background, annotations and unlit props keep their colours. Linear pictures (vtkGIPass::GetRadiance()) are not mapped.
 */
#ifndef vtkGIToneMapping_h
#define vtkGIToneMapping_h

#include "vtkGIToneMappingParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIToneMapping : public vtkGIToneMappingParameters
{
public:
  static vtkGIToneMapping* New();
  vtkTypeMacro(vtkGIToneMapping, vtkGIToneMappingParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;
  int GetRequiredFrames() override;

protected:
  vtkGIToneMapping();
  ~vtkGIToneMapping() override;

private:
  vtkGIToneMapping(const vtkGIToneMapping&) = delete;
  void operator=(const vtkGIToneMapping&) = delete;
};

#endif
