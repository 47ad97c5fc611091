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
constexpr const char* Reprojection = "temporal-accumulation.reprojection";

// Place among the passes that modify a noisy resource: after filters over the neighbourhood.
constexpr int Order = 500;

// Frames after a change in which something old may still be seen.
constexpr int Settling = 8;

// Where a light shines from; whether a mask of it still holds.
using LightPlace = std::array<double, 9>;

LightPlace PlaceOf(const Light& light)
{
  const glm::dvec3& p = light.WorldPosition;
  const glm::dvec3& d = light.WorldDirection;
  return { { p.x, p.y, p.z, d.x, d.y, d.z, light.Positional ? 1.0 : 0.0, light.ConeAngle,
    light.Exponent } };
}

/// How long things have been as they are, in frames with the one being drawn.
struct Ages
{
  int Start = 0;           ///< since accumulation began
  int Looks = 0;           ///< since looks or lights changed
  int Settled = 0;         ///< since props changed
  std::vector<int> Lights; ///< of each channel of the direct visibility
  std::vector<LightPlace> Places;

  void Advance(const View& view, const LightTable& lights, bool continued)
  {
    this->Start = continued ? this->Start + 1 : 1;
    this->Looks = !continued || view.Changes.Appearance || view.Changes.Lights ? 1 : this->Looks + 1;
    this->Settled = view.Changes.Props ? 0 : this->Settled + 1;
    std::vector<LightPlace> now;
    for (const Light& light : lights.Lights())
    {
      const auto channel = static_cast<std::size_t>(light.MaskChannel);
      if (light.MaskChannel >= 0)
      {
        now.resize(std::max(now.size(), channel + 1));
        now[channel] = PlaceOf(light);
      }
    }
    this->Lights.resize(now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
    {
      const bool same = continued && i < this->Places.size() && this->Places[i] == now[i];
      this->Lights[i] = same ? this->Lights[i] + 1 : 1;
    }
    this->Places = now;
  }

  /// Whether what was seen before a change may be in the means.
  bool IsSettling() const { return this->Settled < Settling && this->Settled + 1 < this->Start; }

  int Of(const NoisyResource& noisy, std::size_t channel) const
  {
    const int own =
      noisy.PerLight ? (channel < this->Lights.size() ? this->Lights[channel] : 1) : this->Start;
    return noisy.Appearance ? std::min(own, this->Looks) : own;
  }
};

TextureDesc MeanDesc(const TextureDesc& shown)
{
  TextureDesc desc = shown;
  desc.Format = shown.Format == GL_R8 || shown.Format == GL_R16 ? GL_R32F : GL_RGBA16F;
  return desc;
}

/// A history that is read and one that is written, by turns.
template <typename Kept>
struct Pair
{
  Kept* Before;
  Kept* Now;

  template <typename Keep>
  Pair(const View& view, const std::string& name, const Keep& keep)
  {
    const bool odd = view.FrameNumber % 2 != 0;
    Kept* both[2] = { keep(name + ".even"), keep(name + ".odd") };
    this->Now = both[odd];
    this->Before = both[!odd];
  }
};
using SurfacePair = Pair<History>;

struct Accumulation
{
  MotionTable* Motion;
  const Ages* Age;
  int MaximumFrames;
  int ChangeFrames;
  double DepthTolerance;
  double NormalTolerance;

  int Most(const View& view) const
  {
    constexpr int unlimited = 2048; // half floats hold every integer up to here
    return this->Age->IsSettling() ? this->ChangeFrames
      : view.StillFrames > 0       ? unlimited
                                   : this->MaximumFrames;
  }

  void Begin(ScopedState& scope) const
  {
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, true);
    scope.DepthFunc(GL_GREATER); // only where there is something
    scope.DepthMask(false);
  }

  void Reproject(FrameContext& context, const SurfacePair& surfaces) const
  {
    const View& view = context.GetView();
    const bool continued = this->Motion->IsContinued() && surfaces.Before->Written;
    ScopedState scope(context.State());
    this->Begin(scope);
    context.BindTarget({ { context.Output(Reprojection), -1 }, { &surfaces.Now->Storage, -1 } },
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
        .Set("most", static_cast<double>(this->Most(view)))
        .Set("continued", continued));
  }

  void Accumulate(FrameContext& context, const NoisyResource& noisy) const
  {
    const View& view = context.GetView();
    const Texture* shown = context.Output(noisy.Name);
    const TextureDesc& desc = shown->Desc();
    std::map<const Texture*, bool> fresh;
    const Pair<const Texture> means(view, std::string("temporal-accumulation.") + noisy.Name,
      [&](const std::string& name) {
        bool made = false;
        const Texture& texture = context.Keep(name, MeanDesc(desc), made);
        fresh[&texture] = made;
        return &texture;
      });
    Defines variant;
    if (desc.Layers > 0)
    {
      variant["GI_LAYERS"] = "1";
    }
    if (view.StillFrames > 0)
    {
      variant["GI_STILL"] = "1";
    }
    if (view.StillFrames == 0 || this->Age->IsSettling())
    {
      variant["GI_CLAMP"] = "1";
    }
    ScopedState scope(context.State());
    this->Begin(scope);
    for (int layer = 0; layer < std::max(1, desc.Layers); ++layer)
    {
      const int target = desc.Layers > 0 ? layer : -1;
      context.BindTarget(
        { { means.Now, target }, { shown, target } }, { context.Input(resource::Depth), -1 });
      glm::vec4 most;
      for (int i = 0; i < 4; ++i)
      {
        const int age = fresh[means.Before]
          ? 1
          : this->Age->Of(noisy, static_cast<std::size_t>(4 * layer + i));
        most[i] = static_cast<float>(age);
      }
      context.DrawBound("temporal_accumulation/accumulate.frag", variant,
        Arguments().Sample("history", means.Before).Set("most", most).Set("layer", layer));
    }
  }
};
}

vtkGITemporalAccumulation::vtkGITemporalAccumulation() = default;
vtkGITemporalAccumulation::~vtkGITemporalAccumulation() = default;

void vtkGITemporalAccumulation::Contribute(FrameBuilder& frame)
{
  frame.ChangeNoise();
  Ages& ages = frame.ViewState<Ages>(this);
  MotionTable& motion = frame.Motion();
  const LightTable& lights = frame.Lights();
  const Accumulation work{ &motion, &ages, this->MaximumFrames, this->ChangeFrames,
    this->DepthTolerance, this->NormalTolerance };
  const SurfacePair surfaces(frame.GetView(), "temporal-accumulation.surface",
    [&](const std::string& name) { return &frame.Keep(name, frame.WindowTexture(GL_RGBA32F)); });
  frame.AddPass("temporal-reproject")
    .Read(resource::Depth)
    .Read(resource::DepthCopy)
    .Read(resource::Normal)
    .ReadIfPresent(resource::Displacement, "GI_DISPLACEMENT")
    .Write(Reprojection, frame.WindowTexture(GL_RGBA16F))
    .ReadHistory(*surfaces.Before, "surfaceTexture")
    .WriteHistory(*surfaces.Now)
    .Offer(frame.Capture().Materials().ShaderArguments())
    .Offer(motion.ShaderArguments())
    .Execute([work, surfaces, &ages, &motion, &lights](FrameContext& context) {
      ages.Advance(context.GetView(), lights, motion.IsContinued());
      work.Reproject(context, surfaces);
    });
  for (const NoisyResource& noisy : resource::Noisy)
  {
    frame.AddPass(std::string("temporal-") + noisy.Name)
      .Read(Reprojection, "reprojection")
      .Read(resource::Depth)
      .ModifyIfPresent(noisy.Name, Order, "current")
      .Execute([work, noisy](FrameContext& context) { work.Accumulate(context, noisy); });
  }
}
