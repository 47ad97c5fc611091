// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIRayTracedShadows
 * @brief   ray-traced shadows of directional and positional lights
 *
 * Rays go from each pixel's surface to points on every light. Shadows are accurate to the pixel, and soft
 * if lights have a size. The noise of one ray per frame averages out over still frames. They take precedence
 * over shadow maps, and need no bias.
 */
#ifndef vtkGIRayTracedShadows_h
#define vtkGIRayTracedShadows_h

#include "vtkGIRayTracedShadowsParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIRayTracedShadows : public vtkGIRayTracedShadowsParameters
{
public:
  static vtkGIRayTracedShadows* New();
  vtkTypeMacro(vtkGIRayTracedShadows, vtkGIRayTracedShadowsParameters);

  const char* GetOfferedResource() override;
  int GetRank() override { return 2; }
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIRayTracedShadows();
  ~vtkGIRayTracedShadows() override;

private:
  vtkGIRayTracedShadows(const vtkGIRayTracedShadows&) = delete;
  void operator=(const vtkGIRayTracedShadows&) = delete;
};

#endif
