// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Balls drawn at a technique's probes, lit by what they hold, to look at them.
 */
#pragma once

#include <functional>
#include <string>

namespace penumbra
{
class FrameBuilder;
class PassDeclaration;

/// Add the passes that draw balls over the picture, and over the radiance that is kept. name: of the passes. shader: as
/// probes/show.glsl has it. declare: adds what the shader reads of the probes.
void AddProbeBalls(FrameBuilder& frame, const std::string& name, const std::string& shader,
  const std::function<void(PassDeclaration&)>& declare);
}
