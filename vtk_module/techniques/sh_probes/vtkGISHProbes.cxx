// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGISHProbes.h"

#include "bake/BakeFit.h"
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
  BakedScene Scene; ///< the scene that was baked
  std::string Error;
  std::unique_ptr<ProbeTextures> Textures;
  int Window = -1;   ///< value of the parameter in Textures
  bool Stale = true; ///< Textures belong to an earlier field

  const ProbeTextures& UpToDateTextures(int window)
  {
    if (!this->Textures || this->Stale || this->Window != window)
    {
      this->Textures = std::make_unique<ProbeTextures>(this->Field, window != 0);
      this->Stale = false;
      this->Window = window;
    }
    return *this->Textures;
  }

  // Declares what a pass reads whose shader looks up the probes' light at the surfaces of the picture.
  void ReadField(PassDeclaration& pass, const vtkGISHProbes& settings, const View& view)
  {
    const ProbeTextures& textures = this->UpToDateTextures(settings.Window);
    pass.Offer(textures.ShaderArguments(settings.Bias, textures.Origin()))
      .Offer(view.ToScene(textures.Origin()));
  }

  // Lights translucent surfaces and volumes.
  ForwardPart Forward(const vtkGISHProbes& settings, const View& view)
  {
    ForwardPart part;
    part.Source = "sh_probes/forward.glsl";
    part.OnSurfaces = part.InVolumes = ProbeUniforms{ this->Field.Grids }.Variant();
    part.Textures = 3;
    part.Bind = [this, &settings, toWorld = view.ViewToWorld](ForwardProgram& program) {
      const ProbeTextures& textures = this->UpToDateTextures(settings.Window);
      program.Set(textures.ShaderArguments(settings.Bias, textures.Origin()));
      program.SetTexture("probeLight", textures.Light()->Get());
      program.SetTexture("fieldDistance", textures.Distance()->Get());
      program.SetTexture("fieldProbes", textures.Probes()->Get());
      program.SetField(toWorld, textures.Origin(), settings.Intensity);
    };
    return part;
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
    impl.Scene = image ? BakedScene::FromText(field.Scene) : BakedScene();
    impl.Field = std::move(field);
  }
  catch (const std::invalid_argument& error)
  {
    impl.Error = error.what();
    return false;
  }
  // Textures are replaced in the next frame, where their context is current.
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
  const ViewState* view = this->Views ? this->Views->FindView(renderer) : nullptr;
  const BakeFit* fit = view ? view->Find<BakeFit>(this) : nullptr;
  return fit ? fit->Mismatch() : std::string();
}

void vtkGISHProbes::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Textures.reset();
}

void vtkGISHProbes::Plan(LightingPlan& plan, FrameBuilder& frame)
{
  BakeFit& fit = frame.ViewState<BakeFit>(this);
  if (!this->HasBake())
  {
    fit = BakeFit();
    this->Impl->Textures.reset(); // of a bake that was removed
    frame.AddNote("the probes are on without a bake: make one with penumbra bake probes");
    return;
  }
  fit.Check(frame, this->Impl->Scene, "the probes no longer fit");
  if (fit.Fits())
  {
    plan.AnnounceIndirectLight(IndirectKind::BakedProbes, this->Impl->Field.Grids.Detail());
  }
  else if (this->LiveFallback)
  {
    plan.RequestLiveLight();
  }
}

void vtkGISHProbes::Contribute(FrameBuilder& frame)
{
  if (!this->HasBake())
  {
    return;
  }
  if (frame.ViewState<BakeFit>(this).Fits())
  {
    IndirectLight light;
    light.Kind = IndirectKind::BakedProbes;
    light.Declare = [this, view = frame.GetView()](PassDeclaration& pass) {
      pass.Read(resource::DepthCopy)
        .Read(resource::Albedo)
        .Read(resource::Normal)
        .Offer(this->GetShaderParameters());
      this->Impl->ReadField(pass, *this, view);
    };
    light.Draw = [variant = ProbeUniforms{ this->Impl->Field.Grids }.Variant()](
                   FrameContext& context) {
      Arguments arguments;
      Defines defines = OpenDirection(context, arguments);
      defines.insert(variant.begin(), variant.end());
      context.DrawBound("sh_probes/gather.frag", defines, arguments);
    };
    light.Forward = this->Impl->Forward(*this, frame.GetView());
    frame.AddIndirectLight(std::move(light));
  }
  if (this->Show)
  {
    AddProbeBalls(frame, "probe-balls", "sh_probes/show.frag",
      [&](PassDeclaration& pass) { this->Impl->ReadField(pass, *this, frame.GetView()); });
  }
}
