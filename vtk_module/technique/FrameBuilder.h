// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where techniques add their work to a frame: what they may ask about the scene, and what they
 * tell each other about light.
 */
#pragma once

#include "graph/Frame.h"
#include "graph/ViewState.h"
#include "light/ForwardPart.h"
#include "light/IndirectLight.h"
#include "light/LightTable.h"
#include "technique/LightingPlan.h"

namespace penumbra
{
class MotionTable;
class RayProps;
class SceneCapture;

/// Where a technique adds its work.
class FrameBuilder : public Frame
{
public:
  FrameBuilder(FrameGraph& graph, View& view, LightTable& lights, SceneCapture& scene,
    RayProps& rays, MotionTable& motion, penumbra::ViewState& states,
    const LightingPlan& plan, vtkOpenGLRenderer* renderer, ResourcePool& pool,
    const std::string& viewName)
    : Frame(graph, view, renderer, pool, viewName)
    , CurrentLights(lights)
    , Scene(scene)
    , World(rays)
    , Motions(motion)
    , States(states)
    , CurrentPlan(plan)
  {
  }
  /// What lights this frame: complete when the first technique adds a pass.
  const LightingPlan& Plan() const { return this->CurrentPlan; }
  LightTable& Lights() { return this->CurrentLights; }
  SceneCapture& Capture() { return this->Scene; }
  /// The scene for rays, brought up to date when first asked for in a frame. consequence: what becomes of props that rays
  /// do not see, for a note where there are some ("they cast no shadow").
  RayProps& Rays(const std::string& consequence);

  /// Where things were in the frame before, recorded while the frame is captured. Any number of techniques may ask.
  MotionTable& Motion();

  /// What the owner, a technique, remembers of this view from frame to frame; it lives as long as the view.
  template <typename T>
  T& ViewState(const void* owner)
  {
    return this->States.Of<T>(owner);
  }

  /// Other noise every frame, also while things change: a technique averages over them.
  void ChangeNoise()
  {
    this->CurrentView.Sequence = this->CurrentView.FrameNumber - this->CurrentView.FirstFrame;
  }

  /// Shift this frame's picture by a part of a pixel.
  void SetJitter(const glm::dvec2& pixels);

  /// Have resource::LitRadiance written, and resource::Surroundings where the environment lights.
  void RequestLitRadiance();
  bool WantsLitRadiance() const { return this->LitRadianceWanted; }

  /// A technique knows indirect light, with that of the environment: lights keep their strength.
  void AddIndirectLight(IndirectLight light);
  /// In the order of their kinds.
  const std::vector<IndirectLight>& GetIndirectLights() const { return this->Indirect; }
  /// Have translucent surfaces and volumes, which VTK draws, lit by what is known of the shadowed lights:
  /// functions giVisibility(), see forward/lights.glsl.
  void ShadeForward(ForwardPart visibility) { this->Visibility = std::move(visibility); }
  /// That, and what is known of indirect light there, or else the share of the lights that is spread.
  ForwardLight GetForwardLight() const;

  /// Tell the user something about this frame, in one sentence.
  void AddNote(const std::string& sentence) { this->Notes.push_back(sentence); }
  const std::vector<std::string>& GetNotes() const { return this->Notes; }

private:
  void RequestSurroundings();

  LightTable& CurrentLights;
  SceneCapture& Scene;
  RayProps& World;
  MotionTable& Motions;
  penumbra::ViewState& States;
  const LightingPlan& CurrentPlan;
  bool WorldReady = false;
  bool MotionReady = false;
  bool LitRadianceWanted = false;
  ForwardPart Visibility;
  std::vector<IndirectLight> Indirect;
  std::vector<std::string> Notes;
};
}
