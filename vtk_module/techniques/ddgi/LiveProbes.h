// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probes that rays update: their histories, and the passes of an update (glsl/ddgi).
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

/// The textures of the probes, which are histories of a view.
struct LiveProbeMaps
{
  History* Directions = nullptr; ///< directions of the rays, see glsl/ddgi/directions.glsl
  /// Radiance and distance found by the last update, a row per probe.
  History* RayResults = nullptr;
  History* Light = nullptr;    ///< two maps per probe, see glsl/ddgi/field.glsl
  History* Distance = nullptr;
  History* Probes = nullptr; ///< offset from the grid point, and which neighbours are visible
  /// Offsets that relocation chose, before Connect() moves the probes.
  History* NextOffsets = nullptr;
  History* States = nullptr;

  static LiveProbeMaps Keep(Frame& frame, int probes, int rays);
  /// Whether any of them holds nothing yet.
  bool AreEmpty() const;
  /// Put all probes back on their grid points, without light.
  void Clear(Frame& frame) const;
  /// Declare the reads of a pass whose shader looks up the probes' light.
  void ReadField(PassDeclaration& pass) const;
};

/// An update of all probes, or one frame's part of it. Each function adds the passes of one step.
struct LiveProbeUpdate
{
  ProbeUniforms Uniforms;
  RayProps* Rays = nullptr;
  LightTable* Lights = nullptr;
  bool SkyApart = false; ///< the probes leave out light that arrives straight from the environment
  bool SeeksEmitters = false; ///< rays go to emitters from where others end, see RayProps
  bool KeepsEmitted = false;  ///< the second maps of light are kept up to date
  int RayCount = 0;     ///< per probe
  int UpdateNumber = 0; ///< selects the rotation of the rays' directions
  /// The rays are traced in so many parts, so that light bounces as often in an update: 1, or MaximumParts().
  int Parts = 1;
  int Part = 0;         ///< the part that Trace() and BlendLight() add
  int First = 0;        ///< first probe that this frame updates
  int Last = 0;         ///< one past the last

  /// Number of rays of a probe that go to points of emitters, in addition to RayCount.
  int EmitterRays() const;

  /// Largest number of parts of an update with a number of rays per probe.
  static int MaximumParts(int rays);

  void Trace(Frame& frame, const LiveProbeMaps& maps) const;

  /// Clear the probes that a grid gained when it moved. number: of the grid. moved: in cells.
  void Scroll(
    Frame& frame, const LiveProbeMaps& maps, int number, const glm::ivec3& moved) const;

  /// Choose the offset of each probe from the last update's rays, and give light from a neighbour to those that will move.
  /// Parts is still that of the last update.
  void Relocate(Frame& frame, const LiveProbeMaps& maps, bool geometryMoves) const;

  /// Move the probes in [first, last) to their new offsets, and find which neighbours they see from there.
  void Connect(Frame& frame, const LiveProbeMaps& maps, int first, int last) const;

  /// Blend the radiance of a part's rays into the maps of light. leastShare: minimum share of this part.
  void BlendLight(Frame& frame, const LiveProbeMaps& maps, double leastShare) const;

  /// Blend the rays' distances into the maps of distances. mostUpdates: number of previous updates that are taken
  /// into account, at most. stride: see glsl/ddgi/blend.comp.
  void BlendDistances(Frame& frame, const LiveProbeMaps& maps, int mostUpdates, int stride) const;

private:
  PassDeclaration& AddPass(Frame& frame, const char* name) const;
  void Blend(Frame& frame, const LiveProbeMaps& maps, const char* variant,
    Arguments arguments, History& map) const;
};
}
