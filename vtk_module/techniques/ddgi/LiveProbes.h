// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probes that rays update: what is kept of them, and the work of an update (glsl/ddgi).
 */
#pragma once

#include "probes/ProbeUniforms.h"

namespace penumbra
{
class FrameContext;
class LightTable;
class RayProps;
class Texture;

/// Kept from frame to frame.
struct LiveProbeMaps
{
  Texture* Directions = nullptr; ///< of rays, not turned yet
  Texture* Found = nullptr;      ///< by the rays of the last update
  Texture* Light = nullptr;
  Texture* Distance = nullptr;
  Texture* Probes = nullptr;
  Texture* Places = nullptr; ///< to come into Probes
  Texture* States = nullptr;

  /// fresh: contents are not yet defined.
  static LiveProbeMaps Of(FrameContext& context, int probes, int rays, bool& fresh);
  /// Probes at their grids' places that know nothing.
  void Clear() const;
  void BindStates() const;
};

/// An update, or the part of one that a frame does.
struct LiveProbeUpdate
{
  ProbeUniforms Uniforms;
  RayProps* Rays = nullptr;
  LightTable* Lights = nullptr;
  int RayCount = 0; ///< of a probe
  int Number = 0;   ///< of the update, for the rays' directions
  int First = 0;    ///< of its probes, those that this frame updates
  int Last = 0;     ///< one past them

  void Trace(FrameContext& context, const LiveProbeMaps& maps) const;

  /// After a grid moved by so many cells: probes are new where it had none before.
  void Scroll(
    FrameContext& context, const LiveProbeMaps& maps, int number, const glm::ivec3& moved) const;

  /// Where each probe should stand goes to Places, and light there to those that move.
  void Relocate(FrameContext& context, const LiveProbeMaps& maps, bool geometryMoves) const;

  /// Probes from one to another, that one not counted, go to their Places and learn whom they see from there.
  void Connect(FrameContext& context, const LiveProbeMaps& maps, int first, int last) const;

  /// What the rays found, into the maps of light; least: share of this update in them.
  void BlendLight(FrameContext& context, const LiveProbeMaps& maps, double least) const;

  /// Into those of distances; most: as so many updates before count, at most; stride: see glsl/ddgi/blend.comp.
  void BlendDistances(FrameContext& context, const LiveProbeMaps& maps, int most, int stride) const;

private:
  void TakeOver(FrameContext& context, const LiveProbeMaps& maps) const;
  void Blend(FrameContext& context, const LiveProbeMaps& maps, bool distances, double least,
    int most, int stride) const;
};
}
