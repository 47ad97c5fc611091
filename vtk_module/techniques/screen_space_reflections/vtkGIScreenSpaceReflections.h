// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIScreenSpaceReflections
 * @brief   mirror and glossy reflections of what is on the screen
 *
 * Rays from each reflecting pixel are sampled from its material's lobe and traced through the depth
 * buffer. They return the light of the surface that they hit, and pixels share their neighbours' rays.
 * The result replaces the highlight's share of the environment's light where the screen shows the
 * reflected point; elsewhere the fallback is used. Scenes without reflecting materials cost nothing.
 */
#ifndef vtkGIScreenSpaceReflections_h
#define vtkGIScreenSpaceReflections_h

#include "vtkGIScreenSpaceReflectionsParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIScreenSpaceReflections
  : public vtkGIScreenSpaceReflectionsParameters
{
public:
  static vtkGIScreenSpaceReflections* New();
  vtkTypeMacro(vtkGIScreenSpaceReflections, vtkGIScreenSpaceReflectionsParameters);

  const char* GetOfferedResource() override;
  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIScreenSpaceReflections();
  ~vtkGIScreenSpaceReflections() override;

private:
  bool Reflects(penumbra::FrameBuilder& frame) const;
  vtkGIScreenSpaceReflections(const vtkGIScreenSpaceReflections&) = delete;
  void operator=(const vtkGIScreenSpaceReflections&) = delete;
};

#endif
