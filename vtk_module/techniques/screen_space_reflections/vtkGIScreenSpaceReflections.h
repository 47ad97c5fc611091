// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIScreenSpaceReflections
 * @brief   mirror and glossy reflection of what is on the screen
 *
 * From each reflecting pixel rays go in directions that its material reflects to, through the depth
 * buffer, and bring back the light of the surface that they meet. Pixels share their neighbours' rays.
 * The result takes the place of the highlight's share of the surroundings' light, as far as the screen
 * shows what is reflected; elsewhere stands the fallback. Scenes without reflecting materials cost
 * nothing.
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
  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIScreenSpaceReflections();
  ~vtkGIScreenSpaceReflections() override;

private:
  vtkGIScreenSpaceReflections(const vtkGIScreenSpaceReflections&) = delete;
  void operator=(const vtkGIScreenSpaceReflections&) = delete;
};

#endif
