// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAmbientOcclusion.h"

#include "technique/FrameBuilder.h"

#include "occlusion.h"

vtkStandardNewMacro(vtkGIAmbientOcclusion);

using namespace penumbra;

namespace
{
constexpr const char* Raw = "ambient-occlusion.raw";
constexpr const char* Places = "ambient-occlusion.depth";
constexpr const char* AlongRows = "ambient-occlusion.along-rows";
constexpr const char* Smoothed = "ambient-occlusion.smoothed";

enum Methods
{
  Horizon,
  Hemisphere
};

// Part of the scene's diagonal that the automatic radius takes. A wider one is hardly nearer to
// openness of any reach, as what is farther is often not on the screen.
constexpr double AutomaticRadius = 0.15;
// Part of it that things are deep.
constexpr double AutomaticThickness = 0.07;

// The van der Corput sequence in base 2.
double RadicalInverse(unsigned int i)
{
  double result = 0.0;
  for (double digit = 0.5; i; i >>= 1, digit *= 0.5)
  {
    result += digit * (i & 1);
  }
  return result;
}

// Directions spread as the cosine to the normal (z) weighs them, so that every sample counts
// alike; lengths grow quadratically, as near occluders hide more (Filion and McNaughton 2008).
shared::OcclusionData MakeKernel(int samples)
{
  shared::OcclusionData data;
  for (int i = 0; i < samples; ++i)
  {
    const double radius = std::sqrt((i + 0.5) / samples);
    const double turn = i * 2.39996323;
    const double t = RadicalInverse(static_cast<unsigned int>(i) + 1);
    const double length = 0.05 + 0.95 * t * t;
    data.Kernel[i] = glm::vec4(radius * std::cos(turn) * length, radius * std::sin(turn) * length,
      std::sqrt(1.0 - radius * radius) * length, length);
  }
  return data;
}

// Of the samples of the horizon method, so many lie in one slice, half of them to each side: the
// filter averages slices over pixels, so that places along a slice are worth more than slices.
constexpr int SamplesPerSlice = 32;
// Of the places to one side, one in so many looks for the end of the highest thing.
constexpr int PlacesPerRefinement = 4;

// What is not drawn is on no surface: neighbours would else take for one what another frame left there.
const glm::vec4 Open(1.0f, 0.5f, 0.5f, 0.5f);
const glm::uvec4 Nowhere(glm::floatBitsToUint(1e30f), 0u, 0u, 0u); // a depth near no surface's plane
}

struct vtkGIAmbientOcclusion::Resources
{
  Buffer KernelBlock;
  int Samples = 0;
};

vtkGIAmbientOcclusion::vtkGIAmbientOcclusion()
  : Impl(new Resources)
{
}

vtkGIAmbientOcclusion::~vtkGIAmbientOcclusion() = default;

void vtkGIAmbientOcclusion::ReleaseGraphicsResources(vtkWindow*)
{
  *this->Impl = Resources();
}

const char* vtkGIAmbientOcclusion::GetOfferedResource()
{
  return resource::AmbientVisibility;
}

void vtkGIAmbientOcclusion::Plan(LightingPlan& plan, FrameBuilder&)
{
  plan.SpreadLight(this->AmbientShare);
  plan.SetInterreflection(this->Interreflection);
}

void vtkGIAmbientOcclusion::Contribute(FrameBuilder& frame)
{
  // Occlusion further off is in indirect light that is known.
  const double radius = this->Radius > 0.0
    ? this->Radius
    : std::min(AutomaticRadius * frame.GetView().Diagonal, frame.Plan().IndirectDetail());
  if (radius <= 0.0)
  {
    return;
  }
  double thickness =
    this->Thickness > 0.0 ? this->Thickness : AutomaticThickness * frame.GetView().Diagonal;
  if (thickness >= 2.0 * radius)
  {
    thickness = 0.0; // as good as endless, at less cost
  }
  const int stride = this->Resolution == 0 ? 1 : 2;
  const bool bent =
    this->BentNormals && this->Method == Horizon && frame.Plan().KnowsLightAround();
  Defines variant = { { "GI_STRIDE", std::to_string(stride) } };
  if (bent)
  {
    variant["GI_BENT"] = "1";
  }
  TextureDesc raw = frame.WindowTexture(bent ? GL_RGBA32UI : GL_RG32UI);
  raw.Width = (raw.Width + stride - 1) / stride;
  raw.Height = (raw.Height + stride - 1) / stride;
  const TextureDesc whole = frame.WindowTexture(bent ? GL_RGBA16 : GL_R16);
  // A whole target has the window's depth to test against, and what it does not cover is cleared.
  const Drawing sampled =
    stride > 1 ? Drawing{ false, stride, {} } : Drawing{ true, 1, Nowhere };

  frame.AddPass("ambient-occlusion-depth")
    .Read(resource::DepthCopy)
    .Write(Places, frame.WindowTexture(GL_R32F))
    .Draw("ambient_occlusion/depth.frag", {}, {});
  auto& sample = frame.AddPass("ambient-occlusion")
                   .Read(Places, "depthTexture")
                   .Read(resource::Depth)
                   .Read(resource::Normal)
                   .Write(Raw, raw);
  if (this->Method == Hemisphere)
  {
    this->DeclareHemisphere(sample, variant, radius, sampled);
  }
  else
  {
    this->DeclareHorizon(sample, variant, radius, thickness, sampled);
  }
  const char* input = Raw;
  if (this->Filter)
  {
    variant["GI_AVERAGED"] = "1";
    Defines rows = variant;
    rows["GI_PACKED"] = "1";
    frame.AddPass("ambient-occlusion-filter-rows")
      .Read(Raw, "rawTexture")
      .Read(resource::Depth)
      .Write(AlongRows, raw)
      .Draw("ambient_occlusion/filter.frag", rows, {}, sampled);
    input = AlongRows;
  }
  Defines columns = variant;
  if (this->Filter)
  {
    columns["GI_DOWN"] = "1";
  }
  if (stride > 1)
  {
    columns["GI_PACKED"] = "1";
  }
  const Drawing final = { true, 1, Open };
  frame.AddPass("ambient-occlusion-filter")
    .Read(input, "rawTexture")
    .Read(resource::Depth)
    .Write(stride > 1 ? Smoothed : resource::AmbientVisibility, stride > 1 ? raw : whole)
    .Draw("ambient_occlusion/filter.frag", columns, {}, stride > 1 ? sampled : final);
  if (stride > 1)
  {
    variant.erase("GI_AVERAGED");
    frame.AddPass("ambient-occlusion-upsample")
      .Read(Smoothed, "rawTexture")
      .Read(resource::Depth)
      .Read(resource::DepthCopy)
      .Read(resource::Normal)
      .Write(resource::AmbientVisibility, whole)
      .Draw("ambient_occlusion/upsample.frag", variant, {}, final);
  }
}

void vtkGIAmbientOcclusion::DeclareHemisphere(
  PassDeclaration& pass, Defines variant, double radius, const Drawing& drawing)
{
  if (this->Impl->Samples != this->Samples)
  {
    const shared::OcclusionData kernel = MakeKernel(this->Samples);
    this->Impl->KernelBlock.Upload(GL_UNIFORM_BUFFER, &kernel, sizeof(kernel));
    this->Impl->Samples = this->Samples;
  }
  variant["GI_SAMPLES"] = std::to_string(this->Samples);
  pass.Draw("ambient_occlusion/hemisphere.frag", variant,
    Arguments()
      .Block("OcclusionBlock", this->Impl->KernelBlock)
      .Set("radius", radius)
      .Set("bias", this->Bias * radius),
    drawing);
}

void vtkGIAmbientOcclusion::DeclareHorizon(PassDeclaration& pass, Defines variant, double radius,
  double thickness, const Drawing& drawing)
{
  if (thickness > 0.0)
  {
    variant["GI_THICKNESS"] = "1";
  }
  const int slices = std::max(1, this->Samples / SamplesPerSlice);
  const int places = std::max(1, this->Samples / (2 * slices));
  const int refinements = places / PlacesPerRefinement;
  pass.Draw("ambient_occlusion/horizon.frag", variant,
    Arguments()
      .Set("slices", slices)
      .Set("steps", places - refinements)
      .Set("refinements", refinements)
      .Set("radius", radius)
      .Set("thickness", thickness),
    drawing);
}
