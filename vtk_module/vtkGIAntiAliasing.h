// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkGIAntiAliasing_h
#define vtkGIAntiAliasing_h

#include "vtkGIAntiAliasingParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIAntiAliasing : public vtkGIAntiAliasingParameters
{
public:
  static vtkGIAntiAliasing* New();
  vtkTypeMacro(vtkGIAntiAliasing, vtkGIAntiAliasingParameters);

  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIAntiAliasing();
  ~vtkGIAntiAliasing() override;

private:
  vtkGIAntiAliasing(const vtkGIAntiAliasing&) = delete;
  void operator=(const vtkGIAntiAliasing&) = delete;
};

#endif
