// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkGIAmbientOcclusion_h
#define vtkGIAmbientOcclusion_h

#include "vtkGIAmbientOcclusionParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIAmbientOcclusion : public vtkGIAmbientOcclusionParameters
{
public:
  static vtkGIAmbientOcclusion* New();
  vtkTypeMacro(vtkGIAmbientOcclusion, vtkGIAmbientOcclusionParameters);

  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIAmbientOcclusion();
  ~vtkGIAmbientOcclusion() override;

private:
  vtkGIAmbientOcclusion(const vtkGIAmbientOcclusion&) = delete;
  void operator=(const vtkGIAmbientOcclusion&) = delete;
};

#endif
