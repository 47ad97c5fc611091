// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAmbientOcclusion.h"

#include "private/Frame.h"

vtkStandardNewMacro(vtkGIAmbientOcclusion);

vtkGIAmbientOcclusion::vtkGIAmbientOcclusion() = default;
vtkGIAmbientOcclusion::~vtkGIAmbientOcclusion() = default;

void vtkGIAmbientOcclusion::Contribute(penumbra::FrameBuilder&) {}
