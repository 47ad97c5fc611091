// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkGIShadowMaps_h
#define vtkGIShadowMaps_h

#include "vtkGIShadowMapsParameters.h"

class VTKRENDERINGGI_EXPORT vtkGIShadowMaps : public vtkGIShadowMapsParameters
{
public:
  static vtkGIShadowMaps* New();
  vtkTypeMacro(vtkGIShadowMaps, vtkGIShadowMapsParameters);

  void Contribute(penumbra::FrameBuilder& frame) override;

protected:
  vtkGIShadowMaps();
  ~vtkGIShadowMaps() override;

private:
  vtkGIShadowMaps(const vtkGIShadowMaps&) = delete;
  void operator=(const vtkGIShadowMaps&) = delete;
};

#endif
