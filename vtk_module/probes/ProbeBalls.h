// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws balls at a technique's probes, lit by their light, for inspection.
 */
#pragma once

#include <functional>
#include <string>

namespace penumbra
{
class FrameBuilder;
class PassDeclaration;

/// Add the passes that draw balls over the picture and over the radiance if it is kept. name: of the passes. shader:
/// see probes/show.glsl. declare: declares what the shader reads of the probes.
void AddProbeBalls(FrameBuilder& frame, const std::string& name, const std::string& shader,
  const std::function<void(PassDeclaration&)>& declare);
}
