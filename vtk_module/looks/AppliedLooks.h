// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The looks that renderers have. A look stays until it is removed, whatever happens to the vtkGILook that gave it.
 */
#pragma once

#include "looks/LookDescription.h"

class vtkGIPass;
class vtkRenderer;

namespace penumbra
{
void ApplyLook(
  const std::string& name, const LookDescription& look, vtkRenderer* renderer, vtkGIPass* pass);

void RemoveLook(vtkRenderer* renderer);

/// Show the sky and the background of a renderer's look again, if there is one.
void RestoreLook(vtkRenderer* renderer);

/// The name of a renderer's look, or nullptr.
const char* AppliedLookName(vtkRenderer* renderer);
}
