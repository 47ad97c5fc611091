// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIRayTracedShadows
 * @brief   shadows of directional and positional lights by rays
 *
 * From each pixel's surface rays go to points of every light. Shadows are exact to the pixel and soft
 * where lights have a size; one ray a frame is noise that still frames average away. Where shadow maps
 * are switched on too, these are drawn and not the maps. Needs no bias.
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
