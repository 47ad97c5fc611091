// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Diffuse indirect light of several techniques: a pixel takes it from the first enabled one that has any there. Light of
 * the sky is added to that of a technique that leaves the sky out.
 */
#pragma once

#include "gpu/ShaderLibrary.h"
#include "light/ForwardPart.h"

#include <functional>
#include <vector>

namespace penumbra
{
class Frame;
class FrameContext;
class PassDeclaration;

/// Kinds of indirect light, in order of preference.
enum class IndirectKind
{
  BakedOnSurfaces, ///< baked at the very point
  Sky,             ///< light that arrives straight from the environment; the kinds below leave it out
  Rays,            ///< traced from the point, all around
  LiveProbes,      ///< around the point, for the current scene
  BakedProbes      ///< around the point, for the baked scene
};

/// Whether light of a kind is only a part of what arrives, to which the kinds after it add theirs.
inline bool IsPartOfLight(IndirectKind kind)
{
  return kind == IndirectKind::Sky;
}

/// Whether light of a kind is known at every pixel, so that the kinds after it add nothing there.
inline bool IsEverywhere(IndirectKind kind)
{
  return kind == IndirectKind::Rays;
}

/// Light in space for shaders that trace rays, as a function fieldReflected(), see ddgi/seen_field.glsl.
struct LightField
{
  Defines Variant; ///< tells the shaders which field to include
  /// Declares what their pass reads.
  std::function<void(PassDeclaration&)> Declare;
};

/// A technique's indirect light, on the surfaces in the G-buffer and elsewhere.
struct IndirectLight
{
  IndirectKind Kind;
  /// Declares what the drawing pass reads.
  std::function<void(PassDeclaration&)> Declare;
  /// Draws over resource::Irradiance, which is bound with the props' depth; depth test and depth writes are off.
  /// Outputs a, the share of the pixel's light that the technique supplies, 0 to 1, and in rgb the irradiance divided
  /// by pi, times a. Later techniques fill up what is missing where a is below 1.
  std::function<void(FrameContext&)> Draw;
  /// Light for translucent surfaces and volumes, see forward/indirect.glsl; empty if there is none.
  ForwardPart Forward;
  /// The same light for rays that end there; without Declare if there is none.
  LightField Field;
  /// Draw also writes the direct light of all lights that do not follow the camera, in the same way, to a second
  /// output, resource::LampLight. The direct light then skips those lights there, except for highlights.
  bool IncludesDirectLight = false;
};

/// Variant of probes/gather.glsl that looks up light along the mean unoccluded direction, if ambient occlusion wrote
/// one. Its texture is added to arguments.
Defines OpenDirection(const FrameContext& context, Arguments& arguments);

/// Add the passes that draw resource::Irradiance, and resource::LampLight if any technique supplies it. lights: in
/// order of preference.
void ContributeIndirectLight(Frame& frame, std::vector<IndirectLight> lights);
}
