// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIRayTracedLight
 * @brief   indirect light by rays from each pixel
 *
 * Rays from each pixel's surface find the light of other surfaces, of what glows, and of the environment unless sky light
 * is on. Where they end, live probes (vtkGIDDGI) know the light of further bounces if they are on; without them there is
 * one bounce. The noise of one ray per frame averages out with temporal accumulation. Takes precedence over the probes at
 * the pixels; translucent surfaces and volumes still have the probes' light.
 */
#ifndef vtkGIRayTracedLight_h
#define vtkGIRayTracedLight_h

#include "vtkGIRayTracedLightParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIRayTracedLight : public vtkGIRayTracedLightParameters
{
public:
  static vtkGIRayTracedLight* New();
  vtkTypeMacro(vtkGIRayTracedLight, vtkGIRayTracedLightParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIRayTracedLight();
  ~vtkGIRayTracedLight() override;

private:
  void AddTrace(penumbra::FrameBuilder& frame);

  vtkGIRayTracedLight(const vtkGIRayTracedLight&) = delete;
  void operator=(const vtkGIRayTracedLight&) = delete;
};

#endif
