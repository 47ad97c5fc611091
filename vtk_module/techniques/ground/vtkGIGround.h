// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIGround
 * @brief   a plane under the props, on which their shadows fall
 *
 * A catcher shows the background, darkened by the share of the light that the props keep from it; on a transparent
 * background the shadow is black with the corresponding alpha. A surface is a diffuse ground that is lit as a prop is. The
 * ground is no prop: it has no part in bounds, picking or the renderer's list. It is seen from above only.
 */
#ifndef vtkGIGround_h
#define vtkGIGround_h

#include "vtkGIGroundParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIGround : public vtkGIGroundParameters
{
public:
  static vtkGIGround* New();
  vtkTypeMacro(vtkGIGround, vtkGIGroundParameters);

  bool ChangesLight() override { return false; }
  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIGround();
  ~vtkGIGround() override;

private:
  vtkGIGround(const vtkGIGround&) = delete;
  void operator=(const vtkGIGround&) = delete;

  void ContributeCatcher(penumbra::FrameBuilder& frame);
  void ContributeTraced(penumbra::FrameBuilder& frame);
  void ContributeRim(penumbra::FrameBuilder& frame, int material);
};

#endif
