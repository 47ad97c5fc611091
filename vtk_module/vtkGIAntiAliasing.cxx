// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAntiAliasing.h"

#include "private/Frame.h"

vtkStandardNewMacro(vtkGIAntiAliasing);

vtkGIAntiAliasing::vtkGIAntiAliasing() = default;
vtkGIAntiAliasing::~vtkGIAntiAliasing() = default;

void vtkGIAntiAliasing::Contribute(penumbra::FrameBuilder&) {}
