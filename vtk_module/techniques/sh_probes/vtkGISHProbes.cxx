// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGISHProbes.h"

#include "bake/BakedScene.h"
#include "probes/ProbeBalls.h"
#include "technique/FrameBuilder.h"
#include "techniques/sh_probes/ProbeTextures.h"

#include "vtkImageData.h"

#include <stdexcept>

vtkStandardNewMacro(vtkGISHProbes);

using namespace penumbra;

struct vtkGISHProbes::Internals
{
  ProbeField Field;
  BakedSceneWatch Watch;
  std::map<vtkRenderer*, std::string> Mismatches; ///< of renderers' last frames
  std::string Error;
  std::unique_ptr<ProbeTextures> Textures;
  int Window = -1;   ///< as Textures have it
  bool Stale = true; ///< Textures are of another field

  const ProbeTextures& Ready(int window)
  {
    if (!this->Textures || this->Stale || this->Window != window)
    {
      this->Textures = std::make_unique<ProbeTextures>(this->Field, window != 0);
      this->Stale = false;
      this->Window = window;
    }
    return *this->Textures;
  }

  void Gather(FrameContext& context, const vtkGISHProbes& settings)
  {
    const ProbeTextures& textures = this->Ready(settings.Window);
    const OpenDirection open(context);
    Defines variant = textures.Variant();
    variant.insert(open.Variant.begin(), open.Variant.end());
    const Program& program = context.Shaders().Fragment("sh_probes/gather.frag", variant);
    context.Use(program,
      { context.Input(resource::WindowDepth), context.Input(resource::Albedo),
        context.Input(resource::Normal), open.Map, textures.Light(), textures.Distance(),
        textures.Probes() });
    textures.Set(program, settings.Bias);
    SetProbeView(program, context.GetView(), textures.Origin());
    glUniform1f(program.Location("intensity"), static_cast<GLfloat>(settings.Intensity));
    context.DrawFullscreen();
  }

  // For translucent surfaces and volumes.
  ForwardPart Forward(const vtkGISHProbes& settings, const View& view)
  {
    ForwardPart part;
    part.Source = "sh_probes/forward.glsl";
    part.OnSurfaces = part.InVolumes = ProbeUniforms{ this->Field.Grids }.Variant();
    part.Textures = 3;
    part.Bind = [this, &settings, toWorld = view.ViewToWorld](ForwardProgram& program) {
      const ProbeTextures& textures = this->Ready(settings.Window);
      textures.Set(program, settings.Bias);
      program.SetTexture("probeLight", textures.Light()->Get());
      program.SetTexture("fieldDistance", textures.Distance()->Get());
      program.SetTexture("fieldProbes", textures.Probes()->Get());
      program.SetField(toWorld, textures.Origin(), settings.Intensity);
    };
    return part;
  }

  ProbeBalls Balls(const vtkGISHProbes& settings)
  {
    const ProbeTextures& textures = this->Ready(settings.Window);
    return { "sh_probes/show.frag", textures.Light(), textures.Distance(), textures.Probes(),
      textures.Origin(),
      [&textures, bias = settings.Bias](const Program& program) { textures.Set(program, bias); } };
  }
};

vtkGISHProbes::vtkGISHProbes()
  : Impl(new Internals)
{
}

vtkGISHProbes::~vtkGISHProbes() = default;

bool vtkGISHProbes::SetBake(vtkImageData* image)
{
  Internals& impl = *this->Impl;
  impl.Error.clear();
  try
  {
    ProbeField field = image ? ProbeField::FromImage(image) : ProbeField();
    BakedSceneWatch watch;
    if (image)
    {
      watch.SetBaked(field.Scene);
    }
    impl.Field = std::move(field);
    impl.Watch = std::move(watch);
  }
  catch (const std::invalid_argument& error)
  {
    impl.Error = error.what();
    return false;
  }
  // Textures are freed where their context is current.
  impl.Stale = true;
  this->Modified();
  return true;
}

bool vtkGISHProbes::HasBake()
{
  return !this->Impl->Field.IsEmpty();
}

const char* vtkGISHProbes::GetBakeError()
{
  return this->Impl->Error.c_str();
}

std::string vtkGISHProbes::GetMismatch(vtkRenderer* renderer)
{
  const auto found = this->Impl->Mismatches.find(renderer);
  return found == this->Impl->Mismatches.end() ? std::string() : found->second;
}

void vtkGISHProbes::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Textures.reset();
  this->Impl->Watch.Forget();
}

void vtkGISHProbes::Contribute(FrameBuilder& frame)
{
  if (!this->HasBake())
  {
    frame.AddNote("the probes are on without a bake: make one with penumbra bake probes");
    return;
  }
  const View& view = frame.GetView();
  std::string& mismatch = this->Impl->Mismatches[frame.GetRenderer()];
  mismatch = this->Impl->Watch.Difference(
    frame.GetRenderer(), view.Changes.Props || view.Changes.Looks, view.FrameNumber);
  if (mismatch.empty())
  {
    frame.AddIndirectLight({ IndirectKind::BakedProbes, this->Impl->Field.Grids.Detail(),
      { resource::WindowDepth, resource::Albedo, resource::Normal },
      [this](FrameContext& context) { this->Impl->Gather(context, *this); },
      this->Impl->Forward(*this, view) });
  }
  else
  {
    frame.AddNote("the probes no longer fit: " + mismatch + " since the bake");
    if (this->LiveFallback)
    {
      frame.RequestLiveLight();
    }
  }
  if (this->Show)
  {
    AddProbeBalls(
      frame, "probe-balls", {}, [this](FrameContext&) { return this->Impl->Balls(*this); });
  }
}
