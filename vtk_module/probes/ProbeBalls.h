// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Balls drawn at a technique's probes, lit by what they hold, to look at them.
 */
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

namespace penumbra
{
class FrameBuilder;
class FrameContext;
class Program;
class Texture;
struct View;

/// The uniforms of probes/gather.glsl and probes/show.glsl that tell where the eye is. origin: of the probes'
/// coordinates, world.
void SetProbeView(const Program& program, const View& view, const glm::dvec3& origin);

/// One field's probes, as probes/show.glsl draws them.
struct ProbeBalls
{
  const char* Shader = nullptr;
  const Texture* Light = nullptr;
  const Texture* Distance = nullptr;
  const Texture* Probes = nullptr;
  glm::dvec3 Origin{ 0.0 }; ///< of the probes' coordinates, world
  /// Set the field's uniforms for the program in use, and bind what else its shader reads.
  std::function<void(const Program&)> Set;
};

/// Add the passes that draw balls over the picture, and over the radiance that is kept. name: of the passes. reads:
/// resources that must be there before. balls: asked when a pass runs.
void AddProbeBalls(FrameBuilder& frame, const std::string& name,
  const std::vector<const char*>& reads, const std::function<ProbeBalls(FrameContext&)>& balls);
}
