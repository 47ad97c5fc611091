// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probes that rays update: what is kept of them, and the work of an update (glsl/ddgi).
 */
#pragma once

#include "probes/ProbeUniforms.h"

namespace penumbra
{
class Frame;
class LightTable;
class PassDeclaration;
class RayProps;
struct History;

/// Kept from frame to frame.
struct LiveProbeMaps
{
  History* Directions = nullptr; ///< of rays, not turned yet
  History* Found = nullptr;      ///< by the rays of the last update
  History* Light = nullptr;
  History* Distance = nullptr;
  History* Probes = nullptr;
  History* Places = nullptr; ///< to come into Probes
  History* States = nullptr;

  static LiveProbeMaps Of(Frame& frame, int probes, int rays);
  /// Whether some hold nothing yet.
  bool AreFresh() const;
  /// Probes at their grids' places that know nothing.
  void Clear(Frame& frame) const;
  /// For a pass whose shader asks the probes.
  void ReadField(PassDeclaration& pass) const;
};

/// An update, or the part of one that a frame does: adds passes for its steps.
struct LiveProbeUpdate
{
  ProbeUniforms Uniforms;
  RayProps* Rays = nullptr;
  LightTable* Lights = nullptr;
  int RayCount = 0; ///< of a probe
  int Number = 0;   ///< of the update, for the rays' directions
  int First = 0;    ///< of its probes, those that this frame updates
  int Last = 0;     ///< one past them

  void Trace(Frame& frame, const LiveProbeMaps& maps) const;

  /// After a grid moved by so many cells: probes are new where it had none before.
  void Scroll(
    Frame& frame, const LiveProbeMaps& maps, int number, const glm::ivec3& moved) const;

  /// Where each probe should stand goes to Places, and light there to those that move.
  void Relocate(Frame& frame, const LiveProbeMaps& maps, bool geometryMoves) const;

  /// Probes from one to another, that one not counted, go to their Places and learn whom they see from there.
  void Connect(Frame& frame, const LiveProbeMaps& maps, int first, int last) const;

  /// What the rays found, into the maps of light; least: share of this update in them.
  void BlendLight(Frame& frame, const LiveProbeMaps& maps, double least) const;

  /// Into those of distances; most: as so many updates before count, at most; stride: see glsl/ddgi/blend.comp.
  void BlendDistances(Frame& frame, const LiveProbeMaps& maps, int most, int stride) const;

private:
  PassDeclaration& AddPass(Frame& frame, const char* name) const;
  void Blend(Frame& frame, const LiveProbeMaps& maps, bool distances, double least,
    int most, int stride) const;
};
}
