// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIReflectance
 * @brief   limits and conserves what surfaces reflect
 *
 * Data are often coloured with a reflectance of 1, which no real surface has: light then fades only slowly from bounce to
 * bounce, and hollows glow. MaximumAlbedo scales all reflectances, by the same factor in every technique. Energy
 * compensation restores the light that rough metals lose in VTK's model, which has single scattering only.
 */
#ifndef vtkGIReflectance_h
#define vtkGIReflectance_h

#include "vtkGIReflectanceParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIReflectance : public vtkGIReflectanceParameters
{
public:
  static vtkGIReflectance* New();
  vtkTypeMacro(vtkGIReflectance, vtkGIReflectanceParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIReflectance();
  ~vtkGIReflectance() override;

private:
  vtkGIReflectance(const vtkGIReflectance&) = delete;
  void operator=(const vtkGIReflectance&) = delete;
};

#endif
