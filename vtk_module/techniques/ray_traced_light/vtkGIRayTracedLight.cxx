// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIRayTracedLight.h"

#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"

vtkStandardNewMacro(vtkGIRayTracedLight);

using namespace penumbra;

namespace
{
// Light at the pixels from which rays went in this frame, one for each block of pixels.
constexpr const char* Samples = "ray-traced-light.samples";

// Width and height of the blocks of pixels, by resolution.
glm::ivec2 BlockOf(int resolution)
{
  constexpr int widths[] = { 1, 2, 4, 2 };
  constexpr int heights[] = { 1, 2, 4, 1 };
  return { widths[resolution], heights[resolution] };
}
}

vtkGIRayTracedLight::vtkGIRayTracedLight() = default;
vtkGIRayTracedLight::~vtkGIRayTracedLight() = default;

void vtkGIRayTracedLight::Plan(LightingPlan& plan, FrameBuilder& frame)
{
  if (frame.GetView().Diagonal > 0.0)
  {
    plan.AnnounceIndirectLight(IndirectKind::Rays, 0.0);
  }
}

void vtkGIRayTracedLight::Contribute(FrameBuilder& frame)
{
  if (frame.GetView().Diagonal <= 0.0)
  {
    return;
  }
  const glm::ivec2 block = BlockOf(this->Resolution);
  frame.ShareSamples(resource::TracedIrradiance, block.x * block.y);
  IndirectLight light;
  light.Kind = IndirectKind::Rays;
  light.Declare = [this](PassDeclaration& pass) {
    pass.Read(resource::TracedIrradiance)
      .Read(resource::Albedo)
      .Offer(this->GetShaderParameters());
  };
  light.Draw = [](FrameContext& context) {
    context.DrawBound("ray_traced_light/irradiance.frag", {}, {});
  };
  frame.AddIndirectLight(std::move(light));
  // The probes that know the light where rays end must have been updated.
  frame.AddLast([this](FrameBuilder& last) { this->AddTrace(last); });
}

void vtkGIRayTracedLight::AddTrace(FrameBuilder& frame)
{
  const glm::ivec2 stride = BlockOf(this->Resolution);
  const bool shared = stride.x > 1;
  const View& view = frame.GetView();
  const glm::ivec2 blocks = (glm::ivec2(view.Viewport.z, view.Viewport.w) + stride - 1) / stride;
  RayProps& rays = frame.Rays("they send no indirect light");
  Defines variant = rays.ShaderDefines();
  if (frame.Plan().LightsSky())
  {
    variant["GI_SKY_APART"] = "1";
  }
  auto& pass = frame.AddPass("ray-traced-light");
  const LightField* field = frame.FindLightField();
  if (frame.Plan().LightsSky() || !field)
  {
    variant["GI_SKY_AT_HITS"] = "1";
  }
  if (field ? rays.SeeksEmitters(frame.GetView().Diagonal) : rays.HasEmitters())
  {
    variant["GI_SEEK_EMITTERS"] = "1";
  }
  if (field)
  {
    variant.insert(field->Variant.begin(), field->Variant.end());
    field->Declare(pass);
  }
  pass.Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::DepthCopy)
    .Write(shared ? Samples : resource::TracedIrradiance,
      shared ? TextureDesc{ GL_RGBA32F, blocks.x, blocks.y, 0 } : frame.WindowTexture(GL_RGBA32F),
      "samples")
    .Offer(this->GetShaderParameters())
    .Offer(rays.ShaderArguments())
    .Offer(frame.Lights().InWorld(rays.Origin()))
    .Compute("ray_traced_light/trace.comp", variant,
      Arguments(view.ToScene(rays.Origin()))
        .Set("stride", stride)
        .Set("corner", shared ? glm::ivec2(0) : glm::ivec2(view.Viewport.x, view.Viewport.y)),
      Work::Items(blocks.x, blocks.y));
  if (!shared)
  {
    return;
  }
  frame.AddPass("ray-traced-light-spread")
    .Read(Samples, "samples")
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::DepthCopy)
    .Write(resource::TracedIrradiance, frame.WindowTexture(GL_RGBA32F))
    .Draw("ray_traced_light/spread.frag", {}, Arguments().Set("stride", stride));
}
