// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIDataColors
 * @brief   keeps the colours of data readable under global illumination
 *
 * On surfaces whose colour a mapper takes from data, and on shaded volumes, light from coloured surroundings would shift
 * hues, and shadows would hide values. With this technique indirect light changes their brightness only, and a share of
 * their own colour is always visible.
 */
#ifndef vtkGIDataColors_h
#define vtkGIDataColors_h

#include "vtkGIDataColorsParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIDataColors : public vtkGIDataColorsParameters
{
public:
  static vtkGIDataColors* New();
  vtkTypeMacro(vtkGIDataColors, vtkGIDataColorsParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIDataColors();
  ~vtkGIDataColors() override;

private:
  vtkGIDataColors(const vtkGIDataColors&) = delete;
  void operator=(const vtkGIDataColors&) = delete;
};

#endif
