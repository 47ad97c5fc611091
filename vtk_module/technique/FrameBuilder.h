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
    RayProps& rays, MotionTable& motion, ViewState& states, vtkOpenGLRenderer* renderer)
    : Frame(graph, view, renderer)
    , CurrentLights(lights)
    , Scene(scene)
    , World(rays)
    , Motions(motion)
    , States(states)
  {
  }
  LightTable& Lights() { return this->CurrentLights; }
  SceneCapture& Capture() { return this->Scene; }
  /// The scene for rays, brought up to date when first asked for in a frame.
  RayProps& Rays();

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

  /// A technique averages still frames itself: what it shows needs no further averaging.
  void SetAveraged() { this->Averaged = true; }
  bool IsAveraged() const { return this->Averaged; }

  /// Rays draw all that they see, translucent props too: VTK is not to draw those over them.
  void SetDrawnByRays() { this->DrawnByRays = true; }
  bool IsDrawnByRays() const { return this->DrawnByRays; }

  /// Have resource::LitRadiance written, and resource::Surroundings where the environment lights.
  void RequestLitRadiance();
  bool WantsLitRadiance() const { return this->LitRadianceWanted; }

  /// Take a share of the lights' strength and spread it evenly over all directions.
  void SpreadLight(double share) { this->Share = share; }
  double GetSpreadShare() const { return this->Indirect.empty() ? this->Share : 0.0; }

  /// A technique knows indirect light, with that of the environment: lights keep their strength.
  void AddIndirectLight(IndirectLight light);
  /// In the order of their kinds.
  const std::vector<IndirectLight>& GetIndirectLights() const { return this->Indirect; }
  /// Baked light no longer fits: another technique is to know light that follows the scene.
  void RequestLiveLight() { this->LiveLightWanted = true; }
  /// Whether that is asked for, and nothing else lights the scene so far.
  bool NeedsLiveLight() const
  {
    return this->LiveLightWanted && this->Indirect.empty() && !this->DrawnByRays;
  }
  /// The coarsest detail of what is known so far; infinity where nothing is.
  double GetIndirectDetail() const;

  /// Take surfaces that hide one another from ambient light for reflecting it too, by so much of
  /// their colour.
  void SetInterreflection(double share) { this->Interreflection = share; }
  double GetInterreflection() const { return this->Interreflection; }

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
  bool WorldReady = false;
  bool MotionReady = false;
  bool Averaged = false;
  bool DrawnByRays = false;
  bool LitRadianceWanted = false;
  bool LiveLightWanted = false;
  double Share = 0.0;
  double Interreflection = 0.0;
  ForwardPart Visibility;
  std::vector<IndirectLight> Indirect;
  std::vector<std::string> Notes;
};
}
