// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which technique's indirect diffuse light a pixel takes: the first of those enabled that knows it.
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
class LightTable;
class SceneCapture;

/// By how much is known of a surface point: earlier ones come first.
enum class IndirectKind
{
  BakedOnSurfaces, ///< at this very point
  LiveProbes,      ///< around it, as things are now
  BakedProbes      ///< around it, as things were
};

/// What a technique knows of indirect light, on the surfaces in the G-buffer and elsewhere.
struct IndirectLight
{
  IndirectKind Kind;
  /// Declare what a pass reads that draws over resource::Irradiance, and what it executes. That is bound with the depth
  /// that the props left, tests and writing of depth off: rgb what arrives divided by pi, times a; a the share of the
  /// pixel's light that is known, 0 to 1. What is drawn later counts where and as far as a is below 1.
  std::function<void(PassDeclaration&)> Declare;
  /// Draw it.
  std::function<void(FrameContext&)> Draw;
  /// For translucent surfaces and volumes, see forward/indirect.glsl; empty where it knows nothing of those.
  ForwardPart Forward;
  /// Draw knows what arrives straight from lamps, too, but for those that follow the camera, and writes it to
  /// resource::LampLight, in the same way, as the second output: such lamps light the matter there no more.
  bool KnowsLamps = false;
};

/// For probes/gather.glsl: the variant that reads the mean direction that light comes from past what is near, where it is
/// known, and in given the texture that has it.
Defines OpenDirection(const FrameContext& context, Arguments& given);

/// Add the passes that make resource::Irradiance, and resource::LampLight where one knows it, of what the techniques
/// know, in their order.
void ContributeIndirectLight(
  Frame& frame, const LightTable& lamps, SceneCapture& capture, std::vector<IndirectLight> lights);
}
