// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame as techniques see it: the scene, the lights, and the light that techniques contribute.
 */
#pragma once

#include "graph/Frame.h"
#include "graph/ViewState.h"
#include "light/ForwardPart.h"
#include "light/IndirectLight.h"
#include "light/LightTable.h"
#include "rays/RayPart.h"
#include "technique/LightingPlan.h"

#include <optional>

namespace penumbra
{
class MotionTable;
class RayProps;
class SceneCapture;

class FrameBuilder : public Frame
{
public:
  FrameBuilder(FrameGraph& graph, View& view, LightTable& lights, SceneCapture& scene,
    RayProps& rays, MotionTable& motion, penumbra::ViewState& states, const LightingPlan& plan,
    vtkOpenGLRenderer* renderer, ResourcePool& pool, const std::string& viewName)
    : Frame(graph, view, renderer, pool, viewName)
    , CurrentLights(lights)
    , Scene(scene)
    , TracedScene(rays)
    , Motions(motion)
    , States(states)
    , CurrentPlan(plan)
  {
  }
  /// The lighting of this frame. It is complete before the first technique adds a pass.
  const LightingPlan& Plan() const { return this->CurrentPlan; }
  LightTable& Lights() { return this->CurrentLights; }
  SceneCapture& Capture() { return this->Scene; }
  /// The scene for rays, updated on the first call in a frame. consequence: what happens to props that rays do not see
  /// ("they cast no shadow"), for a note if there are any.
  RayProps& Rays(const std::string& consequence);

  /// Positions in the previous frame, recorded while this frame is captured. May be called several times.
  MotionTable& Motion();

  /// The state that the owner, a technique, keeps for this view. It lives as long as the view.
  template <typename T>
  T& ViewState(const void* owner)
  {
    return this->States.Of<T>(owner);
  }

  /// While techniques plan: tell that the picture is the mean of this number of still frames, including this one.
  void SetAveragedFrames(int frames) { this->FramesInPicture = frames; }
  /// That number, once techniques have planned, if the picture is a mean of linear light; else 0. VTK shows PBR materials by a
  /// nonlinear function, so that the mean of noisy frames would be too dark.
  int AveragedFrames() const;

  /// Use different noise in every frame, even while the scene changes, because a technique averages over frames.
  void ChangeNoise()
  {
    this->CurrentView.Sequence = this->CurrentView.FrameNumber - this->CurrentView.FirstFrame;
  }

  /// Tell that a technique averages still frames, so that filters of noise need not.
  void AverageStillFrames() { this->StillFramesAveraged = true; }
  bool AveragesStillFrames() const { return this->StillFramesAveraged; } ///< for AddLast()

  /// Tell that so many pixels share a sample of a noisy resource in each frame, and take turns.
  void ShareSamples(const std::string& noisy, int pixels) { this->Sharing[noisy] = pixels; }
  /// Number of pixels that share a sample: 1 unless told otherwise. For AddLast().
  int PixelsPerSample(const std::string& noisy) const
  {
    const auto found = this->Sharing.find(noisy);
    return found == this->Sharing.end() ? 1 : found->second;
  }

  /// Shift this frame's picture by a fraction of a pixel.
  void SetJitter(const glm::dvec2& pixels);

  /// While techniques plan: have the passes of this frame reckon with a surface that is no prop. It lies in these bounds,
  /// at distances from near to far along the view direction. The projection is extended to contain
  /// them; props are still clipped as by the camera. part: for rays; nullptr if they pass through it.
  void AddSurface(
    const std::array<double, 6>& bounds, double near, double far, const RayPart* part);

  /// Have passes added after those of everything else, except for what presents the picture. They run when no other pass
  /// can.
  void AddLast(std::function<void(FrameBuilder& frame)> addPasses)
  {
    this->Last.emplace_back(this->GetOwner(), std::move(addPasses));
  }
  void AddLastPasses();

  /// Have resource::LitRadiance written, and resource::Surroundings if there is environment light.
  void RequestLitRadiance();
  bool WantsLitRadiance() const { return this->LitRadianceRequested; }

  /// Add a technique's indirect light. It includes the environment's, unless LightingPlan::LightsSky(). Lights then keep
  /// their full strength.
  void AddIndirectLight(IndirectLight light);
  /// In order of preference.
  const std::vector<IndirectLight>& GetIndirectLights() const { return this->Indirect; }
  /// The preferred one among the lights that are known in space; nullptr if there is none. For AddLast().
  const LightField* FindLightField() const;
  /// Apply the visibility of lights to translucent surfaces and volumes, which VTK draws: functions giVisibility(), see
  /// forward/lights.glsl.
  void ShadeForward(ForwardPart visibility) { this->Visibility = std::move(visibility); }
  /// Map the finished colours of what VTK draws itself to the display: function giDisplayed(), see
  /// tone_mapping/forward.glsl.
  void DisplayForward(ForwardPart display) { this->Display = std::move(display); }
  /// Map direct light by the same function as soon as it is known, with these arguments. See LightingPlan::HasLitParts().
  void DisplayDirectLight(const Arguments& arguments) { this->DirectDisplay = arguments; }
  const std::optional<Arguments>& GetDirectDisplay() const { return this->DirectDisplay; }
  /// This visibility with the indirect light, or with the spread share of the lights if there is no indirect light.
  ForwardLight GetForwardLight() const;

  /// Add a note about this frame for the user, in one sentence.
  void AddNote(const std::string& sentence) { this->Notes.push_back(sentence); }
  const std::vector<std::string>& GetNotes() const { return this->Notes; }

private:
  void RequestSurroundings();

  LightTable& CurrentLights;
  SceneCapture& Scene;
  RayProps& TracedScene;
  MotionTable& Motions;
  penumbra::ViewState& States;
  const LightingPlan& CurrentPlan;
  std::vector<RayPart> RayParts;
  bool TracedSceneReady = false;
  bool MotionReady = false;
  bool LitRadianceRequested = false;
  std::map<std::string, int> Sharing;
  bool StillFramesAveraged = false;
  int FramesInPicture = 0;
  std::vector<std::pair<std::string, std::function<void(FrameBuilder&)>>>
    Last; ///< with the technique
  ForwardPart Visibility;
  ForwardPart Display;
  std::optional<Arguments> DirectDisplay;
  std::vector<IndirectLight> Indirect;
  std::vector<std::string> Notes;
};
}
