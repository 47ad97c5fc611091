// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a technique knows of the lights at points that are in no G-buffer.
 */
#pragma once

#include "private/ShaderLibrary.h"

#include <functional>
#include <string>

class vtkShaderProgram;

namespace penumbra
{
/// How a technique says what of a light arrives at a point.
struct ForwardVisibility
{
  /// A shader part with the two functions giVisibility(), see forward/lights.glsl; "" for none.
  std::string Source;
  Defines OnSurfaces; ///< the part's variant for translucent surfaces
  Defines InVolumes;
  /// Set what the part needs in a program that is about to draw a volume or else a surface; a texture
  /// unit, which is active, for a texture.
  std::function<void(vtkShaderProgram* program, int unit, bool volume)> Bind;
};
}
