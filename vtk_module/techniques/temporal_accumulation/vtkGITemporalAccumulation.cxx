// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGITemporalAccumulation.h"

#include "capture/MotionTable.h"
#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"

#include "vtkOpenGLRenderer.h"

vtkStandardNewMacro(vtkGITemporalAccumulation);

using namespace penumbra;

namespace
{
// Order among the passes that modify a noisy resource: before the filter of denoising.
constexpr int Order = 500;

// Number of frames after a change in which outdated values may still be visible.
constexpr int SettlingFrames = 8;

// Number of frames in the means of shadow maps while the camera moves: they have little noise, and each frame of motion blurs
// their edges.
constexpr int MovingShadowFrames = 4;

// Position, direction and cone of a light. As long as they stay the same, its visibility mask stays valid.
using LightGeometry = std::array<double, 9>;

LightGeometry GeometryOf(const Light& light)
{
  const glm::dvec3& p = light.WorldPosition;
  const glm::dvec3& d = light.WorldDirection;
  return { { p.x, p.y, p.z, d.x, d.y, d.z, light.Positional ? 1.0 : 0.0, light.ConeAngle,
    light.Exponent } };
}

/// Numbers of frames since the last change of each kind, including the frame being drawn.
struct Ages
{
  static constexpr int Never = -2;
  int LastFrame = Never; ///< number of the last frame that was accumulated
  /// Numbers of the frames whose means are kept, by noisy resource.
  std::map<std::string, int> LastMeans;
  int Accumulation = 0;    ///< since accumulation began
  int Means = 0;           ///< in the means; few after props changed
  int Looks = 0;           ///< since looks or lights changed
  int Props = 0;           ///< since props changed; 0 in the frame of the change
  int Lit = 0;             ///< in the means of light on surfaces; few when it changes
  int Lighting =
    0; ///< since looks or lights changed, but for lights that the camera carries; 0 in that frame
  /// In the mean of each channel of the direct visibility: since its light changed, or a prop appeared or disappeared; few
  /// after props moved.
  std::vector<int> Lights;
  bool Restarted = false; ///< the means of all lights began after the last change of props
  std::vector<LightGeometry> Geometries; ///< geometry of the lights in these channels

  void Advance(const View& view, const LightTable& lights, bool continued, int changeFrames)
  {
    this->Accumulation = continued ? this->Accumulation + 1 : 1;
    this->Looks =
      !continued || view.Changes.Appearance || view.Changes.Lights || view.Changes.CarriedLights
      ? 1
      : this->Looks + 1;
    this->Props = view.Changes.Props ? 0 : this->Props + 1;
    this->Means = continued ? this->Means + 1 : 1;
    this->Means = this->IsSettling() ? std::min(this->Means, changeFrames) : this->Means;
    // Where penumbrae overlap, noise is so wide that clamping would keep the shadow of a prop that has gone.
    this->Restarted = view.Changes.Presence || (this->Restarted && !view.Changes.Props);
    const bool changes = view.Changes.Appearance || view.Changes.Lights;
    this->Lighting = changes ? 0 : this->Lighting + 1;
    this->Lit = continued && !view.Changes.Techniques ? this->Lit + 1 : 1;
    this->Lit =
      changes || view.Changes.CarriedLights ? std::min(this->Lit, changeFrames) : this->Lit;
    std::vector<LightGeometry> geometries;
    for (const Light& light : lights.Lights())
    {
      const auto channel = static_cast<std::size_t>(light.MaskChannel);
      if (light.MaskChannel >= 0)
      {
        geometries.resize(std::max(geometries.size(), channel + 1));
        geometries[channel] = GeometryOf(light);
      }
    }
    this->Lights.resize(geometries.size());
    for (std::size_t i = 0; i < geometries.size(); ++i)
    {
      const bool same = continued && !view.Changes.Presence && i < this->Geometries.size() &&
        this->Geometries[i] == geometries[i];
      this->Lights[i] = same ? this->Lights[i] + 1 : 1;
    }
    if (this->AreLightsSettling())
    {
      this->LimitLights(changeFrames);
    }
    this->Geometries = geometries;
  }

  /// Limit the numbers of frames in the means of lights' visibility, also for the frames that follow.
  void LimitLights(int frames)
  {
    for (int& age : this->Lights)
    {
      age = std::min(age, frames);
    }
  }

  /// Whether the means may still contain samples from before a change of props.
  bool IsSettling() const
  {
    return this->Props < SettlingFrames && this->Props + 1 < this->Accumulation;
  }

  /// The same for the visibility of lights.
  bool AreLightsSettling() const { return this->IsSettling() && !this->Restarted; }

  /// The same for light on surfaces, and changes of what lights them. Not for lights that the camera carries: they change light by
  /// less than clamping would, which removes what few rays find.
  bool IsLightSettling() const
  {
    const bool changed = this->Lighting < SettlingFrames && this->Lighting + 1 < this->Lit;
    return changed || this->IsSettling();
  }

  int Of(const NoisyResource& noisy, std::size_t channel) const
  {
    const int age =
      noisy.PerLight ? (channel < this->Lights.size() ? this->Lights[channel] : 1) : this->Means;
    if (noisy.Light)
    {
      return std::min(age, this->Lit);
    }
    return noisy.Appearance ? std::min(age, this->Looks) : age;
  }
};

TextureDesc HistoryDesc(const TextureDesc& shown)
{
  TextureDesc desc = shown;
  // Half floats would lose the last frames of long means: drivers may round toward zero, each time.
  desc.Format = shown.Format == GL_R8 || shown.Format == GL_R16 ? GL_R32F : GL_RGBA32F;
  return desc;
}

/// Two histories that swap roles every frame: one is read, the other written.
template <typename Storage>
struct PingPong
{
  Storage* Previous;
  Storage* Current;

  template <typename Keep>
  PingPong(const View& view, const std::string& name, const Keep& keep)
  {
    const bool odd = view.FrameNumber % 2 != 0;
    Storage* both[2] = { keep(name + ".even"), keep(name + ".odd") };
    this->Current = both[odd];
    this->Previous = both[!odd];
  }
};
using SurfacePair = PingPong<History>;

struct Accumulator
{
  MotionTable* Motion;
  Ages* Age;
  int MaximumFrames;
  int ChangeFrames;
  double DepthTolerance;
  double NormalTolerance;
  int AveragedFrames; ///< see FrameBuilder

  /// Whether the mean of a result guides a filter, while the result has this frame's values.
  bool IsGuide(const NoisyResource& noisy) const { return noisy.Mean && this->AveragedFrames > 1; }

  int MaximumAge(const View& view) const
  {
    constexpr int unlimited = 2048; // half floats represent every integer up to this one
    return view.StillFrames > 0 ? unlimited : this->MaximumFrames;
  }

  /// Whether the history of a result may be outdated.
  bool Clamps(const NoisyResource& noisy, const View& view) const
  {
    if (noisy.Light)
    {
      return this->Age->IsLightSettling();
    }
    const bool settling = noisy.PerLight ? this->Age->AreLightsSettling() : this->Age->IsSettling();
    return view.StillFrames == 0 || settling;
  }

  void Begin(ScopedState& scope) const
  {
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, true);
    scope.DepthFunc(GL_GREATER); // only pixels with a surface
    scope.DepthMask(false);
  }

  void Reproject(FrameContext& context, const SurfacePair& surfaces, const LightTable& lights) const
  {
    const View& view = context.GetView();
    // The graph leaves this pass out of frames without a noisy resource.
    const bool continued = this->Motion->IsContinued() && surfaces.Previous->Written &&
      this->Age->LastFrame + 1 == view.FrameNumber;
    this->Age->Advance(view, lights, continued, this->ChangeFrames);
    this->Age->LastFrame = view.FrameNumber;
    ScopedState scope(context.State());
    this->Begin(scope);
    context.BindTarget(
      { { context.Output(resource::Reprojection), -1 }, { &surfaces.Current->Storage, -1 } },
      { context.Input(resource::Depth), -1 });
    const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_COLOR, 1, nothing);
    Defines variant;
    if (view.StillFrames > 0)
    {
      variant["GI_STILL"] = "1";
    }
    if (this->Motion->PropsMove())
    {
      variant["GI_PROPS_MOVE"] = "1";
    }
    context.DrawBound("temporal_accumulation/reproject.frag", variant,
      Arguments()
        .Set("tolerance",
          glm::vec2(this->DepthTolerance, std::cos(glm::radians(this->NormalTolerance))))
        .Set("most", static_cast<double>(this->MaximumAge(view)))
        .Set("continued", continued));
  }

  void Accumulate(FrameContext& context, const NoisyResource& noisy) const
  {
    const View& view = context.GetView();
    const Texture* shown = context.Output(noisy.Name);
    const TextureDesc& desc = shown->Desc();
    std::map<const Texture*, bool> isNew;
    const PingPong<const Texture> means(
      view, std::string("temporal-accumulation.") + noisy.Name, [&](const std::string& name) {
        bool created = false;
        const Texture& texture = context.Keep(name, HistoryDesc(desc), created);
        isNew[&texture] = created;
        return &texture;
      });
    int& lastMean = this->Age->LastMeans.emplace(noisy.Name, Ages::Never).first->second;
    const bool restarts = isNew[means.Previous] || lastMean + 1 != view.FrameNumber;
    lastMean = view.FrameNumber;
    Defines variant;
    if (desc.Layers > 0)
    {
      variant["GI_LAYERS"] = "1";
    }
    if (view.StillFrames > 0)
    {
      variant["GI_STILL"] = "1";
    }
    if (this->Clamps(noisy, view))
    {
      variant["GI_CLAMP"] = "1";
    }
    ScopedState scope(context.State());
    this->Begin(scope);
    const Texture* reach =
      noisy.Reach && context.Input(noisy.Reach) ? context.Output(noisy.Reach) : nullptr;
    const Texture* guide = this->IsGuide(noisy) ? context.Output(noisy.Mean) : nullptr;
    if (guide)
    {
      variant["GI_GUIDE"] = "1";
    }
    else if (reach)
    {
      variant["GI_REACH"] = "1";
    }
    const bool mapped = noisy.PerLight && !reach; // rays know how far their noise reaches
    if (mapped && view.StillFrames == 0)
    {
      this->Age->LimitLights(MovingShadowFrames);
    }
    for (int layer = 0; layer < std::max(1, desc.Layers); ++layer)
    {
      const int target = desc.Layers > 0 ? layer : -1;
      std::vector<Attachment> targets = { { means.Current, target }, { shown, target } };
      if (const Texture* third = guide ? guide : reach)
      {
        targets.push_back({ third, target });
      }
      context.BindTarget(targets, { context.Input(resource::Depth), -1 });
      glm::vec4 maximumAge;
      for (int i = 0; i < 4; ++i)
      {
        const int age =
          restarts ? 1 : this->Age->Of(noisy, static_cast<std::size_t>(4 * layer + i));
        maximumAge[i] = static_cast<float>(age);
      }
      context.DrawBound("temporal_accumulation/accumulate.frag", variant,
        Arguments()
          .Sample("history", means.Previous)
          .Set("most", maximumAge)
          .Set("layer", layer)
          .Set("recency", noisy.Light && view.StillFrames > 0 ? 1.0 : 0.0)
          .Set("counts", noisy.Light)
          .Set("averagedFrames", static_cast<double>(this->AveragedFrames)));
    }
  }
};
}

vtkGITemporalAccumulation::vtkGITemporalAccumulation() = default;
vtkGITemporalAccumulation::~vtkGITemporalAccumulation() = default;

void vtkGITemporalAccumulation::Contribute(FrameBuilder& frame)
{
  frame.ChangeNoise();
  frame.AverageStillFrames();
  Ages& ages = frame.ViewState<Ages>(this);
  MotionTable& motion = frame.Motion();
  const LightTable& lights = frame.Lights();
  const Accumulator accumulator{ &motion, &ages, this->MaximumFrames, this->ChangeFrames,
    this->DepthTolerance, this->NormalTolerance, frame.AveragedFrames() };
  const SurfacePair surfaces(frame.GetView(), "temporal-accumulation.surface",
    [&](const std::string& name) { return &frame.Keep(name, frame.WindowTexture(GL_RGBA32F)); });
  frame.AddPass("temporal-reproject")
    .Read(resource::Depth)
    .Read(resource::DepthCopy)
    .Read(resource::Normal)
    .ReadIfPresent(resource::Displacement, "GI_DISPLACEMENT")
    .Write(resource::Reprojection, frame.WindowTexture(GL_RGBA16F))
    .ReadHistory(*surfaces.Previous, "surfaceTexture")
    .WriteHistory(*surfaces.Current)
    .Offer(frame.Capture().Materials().ShaderArguments())
    .Offer(motion.ShaderArguments())
    .Execute([accumulator, surfaces, &lights](
               FrameContext& context) { accumulator.Reproject(context, surfaces, lights); });
  for (const NoisyResource& noisy : resource::Noisy)
  {
    if (noisy.Surface)
    {
      continue; // it is a mean already
    }
    auto& pass = frame.AddPass(std::string("temporal-") + noisy.Name)
                   .Read(resource::Reprojection)
                   .Read(resource::Depth)
                   .ModifyIfPresent(noisy.Name, Order, "current");
    if (noisy.Reach)
    {
      pass.ModifyIfPresent(noisy.Reach, Order, "reachTexture");
    }
    if (accumulator.IsGuide(noisy))
    {
      pass.Write(noisy.Mean, frame.WindowTexture(GL_RGBA32F));
    }
    pass.Execute(
      [accumulator, noisy](FrameContext& context) { accumulator.Accumulate(context, noisy); });
  }
}
