// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame in the making: what a technique may ask about the view and the scene, where it adds its
 * passes, and what a pass has at hand while it runs.
 */
#pragma once

#include "private/ForwardPart.h"
#include "private/FrameGraph.h"
#include "private/IndirectLight.h"
#include "private/LightTable.h"
#include "private/ResourcePool.h"
#include "private/ShaderLibrary.h"
#include "private/ViewState.h"

#include "view.h"

#include <glm/glm.hpp>

class vtkOpenGLRenderWindow;
class vtkOpenGLRenderer;
class vtkOpenGLState;

namespace penumbra
{
class MotionTable;
class RayProps;
class SceneCapture;

/// Names of the resources that passes share. A technique meets the others only through these.
namespace resource
{
constexpr const char* Depth = "depth";               ///< the depth buffer, to test against
constexpr const char* Albedo = "gbuffer.albedo";     ///< rgb, a: 1 where captured
constexpr const char* Normal = "gbuffer.normal";     ///< octahedral, material
constexpr const char* Facet = "gbuffer.facet";       ///< see capture/declarations.glsl
constexpr const char* WindowDepth = "gbuffer.depth"; ///< a copy of it, to read meanwhile
constexpr const char* Ambient = "gbuffer.ambient";   ///< ambient light reflected
constexpr const char* Surface = "gbuffer.surface";   ///< see capture/gbuffer.glsl
constexpr const char* Emission = "gbuffer.emission"; ///< radiance not due to light
constexpr const char* Displacement =
  "gbuffer.displacement"; ///< how far a point of a deforming surface was from here, one frame ago
constexpr const char* DirectVisibility = "visibility.direct"; ///< a channel per shadowed light
constexpr const char* Surroundings =
  "gbuffer.surroundings"; ///< the part of Ambient that PBR highlights reflect of the environment
constexpr const char* AmbientVisibility =
  "visibility.ambient";                          ///< r: 0 closed to 1 open; see giOpen() for more
constexpr const char* Irradiance = "irradiance"; ///< see IndirectLight.h
constexpr const char* LampLight = "irradiance.lamps"; ///< see IndirectLight.h
/// A skybox behind everything, where there is one: rgb as its shader ends, unclamped; a: 1 where that is for display.
constexpr const char* Sky = "sky";
constexpr const char* LitRadiance = "radiance.lit"; ///< linear, with direct light; where asked for
constexpr const char* Reflection = "reflection";    ///< radiance over each pixel's lobe, confidence
constexpr const char* Color = "color";              ///< the picture, as displayed
constexpr const char* Radiance = "radiance";        ///< the picture, linear
}

/// Results of few samples that share the noise of a frame, in the order of their names: what
/// accumulates over frames.
struct NoisyResource
{
  const char* Name;
  bool PerLight; ///< a channel for each shadowed light, else of the scene as a whole
  bool Looks;    ///< depends on what surfaces look like, not only on where they are
};
namespace resource
{
constexpr NoisyResource Noisy[] = { { AmbientVisibility, false, false },
  { DirectVisibility, true, false }, { Reflection, false, true } };
}

/// What differs from the frame before.
struct SceneChanges
{
  bool Any = true;
  bool Lights = true;
  bool Props = true; ///< one moved, came or went, or looks different
  bool Looks = true; ///< shapes, colours
};

/// The camera and the window of a frame, in double precision where it matters.
struct View
{
  glm::ivec2 WindowSize{ 0 };
  glm::ivec4 Viewport{ 0 }; ///< x, y, width, height
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToWorld{ 1.0 };
  glm::dmat4 ViewToClip{ 1.0 }; ///< with jitter
  bool Parallel = false;
  glm::dvec2 Jitter{ 0.0 };                                ///< in pixels
  std::array<double, 6> Bounds{ { 1, -1, 1, -1, 1, -1 } }; ///< of all visible props, world
  double Diagonal = 0.0;                                   ///< of Bounds
  int StillFrames = 0; ///< frames drawn since the scene last changed, this one not counted
  int FrameNumber = 0;
  int FirstFrame = 0;       ///< number of the one that averages over frames began with
  bool StandsAlone = false; ///< the picture shows nothing that was found in frames before
  int Sequence = 0;         ///< place in the sequences of noise
  SceneChanges Changes;
  GLenum DepthFormat = 0;         ///< of the window, so that depth can be copied; 0 if it cannot
  bool KeepsRadiance = false;     ///< values above 1 matter
  bool WantsAntiAliasing = false; ///< the window is multisampled, or the renderer asks for FXAA
};

/// What a running pass has at hand.
class FrameContext
{
public:
  const View& GetView() const;
  ShaderLibrary& Shaders() const;
  vtkOpenGLState* State() const;
  vtkOpenGLRenderer* Renderer() const;

  /// A texture that the pass declared; nullptr for one it reads if present and that is absent.
  const Texture* Input(const char* resource) const;
  const Texture* Output(const char* resource) const;

  /// Bind outputs (and depth, if named) as the target to draw to. The final version of the
  /// picture binds VTK's own framebuffer.
  void BindTarget(const std::vector<const char*>& outputs, const char* depth = nullptr) const;
  void BindTarget(const std::vector<Attachment>& colors, const Attachment& depth) const;
  /// True where the output is drawn straight into VTK's framebuffer.
  bool IsWindow(const char* output) const;

  /// Make a program current and bind textures to its units, in order.
  void Use(const Program& program, const std::vector<const Texture*>& textures) const;

  /// Copy the viewport's part of a depth texture to another of the same format.
  void CopyDepth(const Texture* from, const Texture* to) const;

  /// One triangle over the viewport, at the far plane.
  void DrawFullscreen() const;

  /// A texture kept for this view from frame to frame. fresh: it was made or resized just now.
  Texture& History(const char* name, const TextureDesc& desc, bool& fresh) const;

private:
  friend class FrameExecutor;
  class FrameExecutor* Executor = nullptr;
  const FrameGraph::Step* Step = nullptr;
};

/// Where a technique adds its work.
class FrameBuilder
{
public:
  FrameBuilder(FrameGraph& graph, View& view, LightTable& lights, SceneCapture& scene,
    RayProps& rays, MotionTable& motion, ViewState& states, vtkOpenGLRenderer* renderer)
    : Graph(graph)
    , CurrentView(view)
    , CurrentLights(lights)
    , Scene(scene)
    , World(rays)
    , Motions(motion)
    , States(states)
    , Renderer(renderer)
  {
  }
  PassDeclaration& AddPass(const std::string& name) { return this->Graph.AddPass(name); }
  const View& GetView() const { return this->CurrentView; }
  vtkOpenGLRenderer* GetRenderer() const { return this->Renderer; }
  LightTable& Lights() { return this->CurrentLights; }
  SceneCapture& Capture() { return this->Scene; }
  /// The scene for rays, brought up to date when first asked for in a frame.
  RayProps& Rays();

  /// Where things were in the frame before, recorded while the frame is captured.
  MotionTable& Motion();

  /// What the owner, a technique, remembers of this view from frame to frame; it lives as long as the view.
  template <typename T>
  T& ViewState(const void* owner)
  {
    return this->States.Of<T>(owner);
  }

  /// The shape of a texture of the window's size.
  TextureDesc WindowTexture(GLenum format, int layers = 0) const
  {
    return { format, this->CurrentView.WindowSize.x, this->CurrentView.WindowSize.y, layers };
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

  FrameGraph& Graph;
  View& CurrentView;
  LightTable& CurrentLights;
  SceneCapture& Scene;
  RayProps& World;
  MotionTable& Motions;
  penumbra::ViewState& States;
  vtkOpenGLRenderer* Renderer;
  bool WorldReady = false;
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
