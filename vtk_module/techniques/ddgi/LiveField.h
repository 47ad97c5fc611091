// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The live probes of one view: the placement of their grids, and the schedule of their updates.
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
  /// Parameters of vtkGIDDGI.
  struct Settings
  {
    int Probes = 0; ///< in all grids together
    int Grids = 1;
    double Refinement = 0.0; ///< 0: derived from what the camera shows
    int Rays = 0;            ///< per probe and update
    int RaysBudget = 0;      ///< per frame; 0: no limit
    int Slices = 1;          ///< number of frames that share an update, unless the scene changes
    int Updates = 0;         ///< number of updates of a still scene after which the probes rest
    double Hysteresis = 0.0;
    double Bias = 0.0;
    bool Relocate = false;

    /// Number of probes that a frame updates. slices: number of frames that share an update.
    int ProbesPerFrame(int probes, int slices) const;
  };

  /// Fit the grids to the scene, and restart what a change invalidated. Call before each frame.
  /// parameters: modification time of the technique's parameters.
  void BeginFrame(const View& view, const Settings& settings, vtkMTimeType parameters);

  /// Add one frame's part of an update, or several updates if the frame stands alone; nothing once the probes rest.
  /// skyApart: leave out light that arrives straight from the environment. A change of this clears the probes.
  void AddUpdates(Frame& frame, RayProps& rays, LightTable& lights, bool skyApart);

  const ProbeGrids& Grids() const { return this->Update.Uniforms.Grids; }
  const ProbeUniforms& Uniforms() const { return this->Update.Uniforms; }
  const LiveProbeMaps& Maps() const { return this->ProbeMaps; }
  int UpdatesDone() const { return this->UpdatesSinceChange; }

private:
  void AddUpdate(Frame& frame, RayProps& rays, LightTable& lights);
  void BlendDistances(Frame& frame);
  void CreateGrids(const View& view);
  void Follow(Frame& frame);
  void Advance();

  Settings Current;
  NestedGrids Nested;
  /// Numbers of probes and grids that the grids were created for.
  std::array<int, 2> RequestedLayout{};
  vtkMTimeType Parameters = 0; ///< modification time of the parameters in use
  LiveProbeMaps ProbeMaps;
  LiveProbeUpdate Update;
  bool Uninitialized = true;  ///< the probes hold no light yet
  bool GeometryMoved = false; ///< since the last relocation
  int NextProbe = 0;          ///< next probe to update
  /// Number of probes from NextProbe on whose visibility of each other may have changed.
  int UnconnectedProbes = 0;
  int TotalUpdates = 0; ///< since the grids were created
  /// Number of whole updates whose results of rays are kept. The first may have begun before the results were kept.
  int CompleteRayResults = 0;
  /// Since a change other than motion of the camera and of lights that follow it.
  int UpdatesSinceOtherChange = 0;
  int UpdatesSinceSceneChange =
    0; ///< since such a change, or motion of lights that follow the camera
  int UpdatesSinceChange = 0;       ///< since the scene changed or a grid moved
  int DistanceUpdates = 0;          ///< since geometry changed
  int DistanceUpdatesSinceMove = 0; ///< since geometry changed or a grid moved
};
}
