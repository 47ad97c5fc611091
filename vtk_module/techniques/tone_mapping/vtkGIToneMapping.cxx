// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIToneMapping.h"

#include "technique/FrameBuilder.h"

vtkStandardNewMacro(vtkGIToneMapping);

using namespace penumbra;

vtkGIToneMapping::vtkGIToneMapping() = default;
vtkGIToneMapping::~vtkGIToneMapping() = default;

namespace
{
// Order among the passes that modify the picture: after those that average it, before the edge filter.
constexpr int MapOrder = 805;
}

int vtkGIToneMapping::GetRequiredFrames()
{
  // The first frame after a change may still be adapting.
  return this->AutoExposure ? 2 : 1;
}

void vtkGIToneMapping::Plan(LightingPlan& plan, FrameBuilder&)
{
  plan.MapTones();
  if (this->AutoExposure)
  {
    plan.KeepLitParts(); // they are measured
  }
}

void vtkGIToneMapping::Contribute(FrameBuilder& frame)
{
  Defines variant;
  const Arguments arguments = Arguments()
                                .Set("scale", std::exp2(this->Exposure))
                                .Set("curve", this->Curve);
  History* exposure = nullptr;
  if (this->AutoExposure)
  {
    variant["GI_AUTO"] = "1";
    exposure = &frame.Keep("tone-mapping.exposure", { GL_RGBA32F, 1, 1, 0 });
    const View& view = frame.GetView();
    const bool adapted = view.StillFrames > 0 || view.StandsAlone || !exposure->Written;
    frame.AddPass("measure-exposure")
      .Read(resource::LitShown)
      .Read(resource::LitEncoded)
      .UpdateHistory(*exposure, "exposure")
      .Compute("tone_mapping/measure.comp", {},
        Arguments().Set("share", adapted ? 1.0 : 1.0 / this->AdaptationFrames), Work::Items(1, 1));
  }
  if (frame.Plan().HasLitParts())
  {
    auto& map = frame.AddPass("tone-mapping");
    if (exposure)
    {
      map.ReadHistory(*exposure, "exposureTexture");
    }
    map.Read(resource::LitShown)
      .Read(resource::LitEncoded)
      .Modify(resource::Color, MapOrder, "before")
      .Draw("tone_mapping/map.frag", variant, arguments);
  }
  const Arguments forward = Arguments(arguments).Set("giMapsTones", true);
  if (!frame.Plan().HasLitParts())
  {
    frame.DisplayDirectLight(forward);
  }
  ForwardPart display;
  display.Source = "tone_mapping/forward.glsl";
  display.OnSurfaces = variant;
  display.Textures = exposure ? 1 : 0;
  display.Bind = [exposure, forward](ForwardProgram& program) {
    program.Set(forward);
    if (exposure)
    {
      program.SetTexture("exposureTexture", exposure->Storage.Get());
    }
  };
  frame.DisplayForward(display);
}
