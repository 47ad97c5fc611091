// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIShadowMaps.h"

#include "private/Frame.h"

vtkStandardNewMacro(vtkGIShadowMaps);

vtkGIShadowMaps::vtkGIShadowMaps() = default;
vtkGIShadowMaps::~vtkGIShadowMaps() = default;

void vtkGIShadowMaps::Contribute(penumbra::FrameBuilder&) {}
