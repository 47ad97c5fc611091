// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The live probes of one view: where their grids stand, and when they are updated how.
 */
#pragma once

#include "techniques/ddgi/LiveProbes.h"
#include "techniques/ddgi/NestedGrids.h"

#include "vtkType.h"

#include <array>

namespace penumbra
{
struct SceneChanges;
struct View;

class LiveField
{
public:
  /// What a view's field follows in all of its frames.
  struct Settings
  {
    int Probes = 0; ///< in all grids
    int Grids = 1;
    double Refinement = 0.0; ///< 0: by what the camera shows
    int Rays = 0;            ///< of a probe in an update
    int RaysBudget = 0;      ///< in a frame; 0: no limit
    int Updates = 0;         ///< after which it rests
    double Hysteresis = 0.0;
    double Bias = 0.0;
    bool Relocate = false;

    int ProbesPerFrame(int most) const;
  };

  /// Before each frame: grids that suit the scene, and what is no longer true. parameters: when any was changed.
  void Prepare(const View& view, const Settings& settings, vtkMTimeType parameters);

  /// Add a frame's part of an update, or several updates to a frame that stands alone; nothing once the probes rest.
  void AddUpdates(Frame& frame, RayProps& rays, LightTable& lights);

  const ProbeGrids& Grids() const { return this->Update.Uniforms.Grids; }
  const ProbeUniforms& Uniforms() const { return this->Update.Uniforms; }
  const LiveProbeMaps& Maps() const { return this->Textures; }
  int UpdatesDone() const { return this->Done; }

private:
  bool Rests() const { return this->Done >= this->Now.Updates; }
  bool IsLastPart() const { return this->Update.Last >= this->Grids().Size(); }
  void Trace(Frame& frame, RayProps& rays, LightTable& lights);
  void Blend(Frame& frame);
  void MakeGrids(const View& view);
  void Follow(Frame& frame);
  void Advance();

  Settings Now;
  NestedGrids Nested;
  std::array<int, 2> Asked{}; ///< of the settings, that the grids were made for
  vtkMTimeType Parameters = 0;
  LiveProbeMaps Textures;
  LiveProbeUpdate Update;
  bool Unknown = true; ///< nothing is known yet
  bool Moved = false;  ///< geometry, since it was judged where probes should stand
  int Next = 0;        ///< probe to be updated
  int Unconnected = 0; ///< of them, from Next on: sight of each other may have changed
  // Updates,
  int Total = 0;  ///< since the grids were made
  int Known = 0;  ///< since the scene changed
  int Done = 0;   ///< since that or since a grid moved
  int Seen = 0;   ///< of distances, since geometry changed
  int Looked = 0; ///< since that or since a grid moved
};
}
