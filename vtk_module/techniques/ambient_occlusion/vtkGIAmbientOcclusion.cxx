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
constexpr const char* DepthCopy = "ambient-occlusion.depth";
constexpr const char* FilteredRows = "ambient-occlusion.along-rows";
constexpr const char* Smoothed = "ambient-occlusion.smoothed";

enum Methods
{
  Horizon,
  Hemisphere
};

// Automatic radius, as a fraction of the scene's diagonal. A wider one brings the result hardly closer to
// occlusion of unlimited distance, because occluders that are farther away are often off the screen.
constexpr double AutomaticRadius = 0.15;
// Automatic thickness of objects, as a fraction of the scene's diagonal.
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

// Cosine-distributed directions around the normal (z), so that all samples have the same weight. Lengths
// grow quadratically, because near occluders hide more (Filion and McNaughton 2008).
shared::OcclusionData MakeKernel(int samples)
{
  shared::OcclusionData data;
  for (int i = 0; i < samples; ++i)
  {
    const double radius = std::sqrt((i + 0.5) / samples);
    const double angle = i * 2.39996323;
    const double t = RadicalInverse(static_cast<unsigned int>(i) + 1);
    const double length = 0.05 + 0.95 * t * t;
    data.Kernel[i] = glm::vec4(radius * std::cos(angle) * length, radius * std::sin(angle) * length,
      std::sqrt(1.0 - radius * radius) * length, length);
  }
  return data;
}

// Number of samples of the horizon method in one slice, half of them to each side. The filter averages
// slices over neighbouring pixels, so more steps along a slice are worth more than more slices.
constexpr int SamplesPerSlice = 32;
// One in this many steps to a side is spent on refining the edge of the highest occluder.
constexpr int StepsPerRefinement = 4;

// Clear values for pixels without a surface. Otherwise the filters would read what an earlier frame left there.
const glm::vec4 FullyOpen(1.0f, 0.5f, 0.5f, 0.5f);
const glm::uvec4 NoSurface(
  glm::floatBitsToUint(1e30f), 0u, 0u, 0u); // a depth far from any surface's plane
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
  // Indirect light that another technique supplies already contains more distant occlusion.
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
    thickness = 0.0; // treated as infinite, which looks the same and is cheaper
  }
  const int stride = this->Resolution == 0 ? 1 : 2;
  const bool bent = this->BentNormals && this->Method == Horizon &&
    frame.Plan().HasLightInSpace() && !frame.Plan().HasKind(IndirectKind::Rays);
  Defines variant = { { "GI_STRIDE", std::to_string(stride) } };
  if (bent)
  {
    variant["GI_BENT"] = "1";
  }
  TextureDesc raw = frame.WindowTexture(bent ? GL_RGBA32UI : GL_RG32UI);
  raw.Width = (raw.Width + stride - 1) / stride;
  raw.Height = (raw.Height + stride - 1) / stride;
  const TextureDesc fullSize = frame.WindowTexture(bent ? GL_RGBA16 : GL_R16);
  // A full-size target is tested against the window's depth, and pixels without a surface are cleared.
  const Drawing samplingDrawing =
    stride > 1 ? Drawing{ false, stride, {} } : Drawing{ true, 1, NoSurface };

  frame.AddPass("ambient-occlusion-depth")
    .Read(resource::DepthCopy)
    .Write(DepthCopy, frame.WindowTexture(GL_R32F))
    .Draw("ambient_occlusion/depth.frag", {}, {});
  auto& sample = frame.AddPass("ambient-occlusion")
                   .Read(DepthCopy, "depthTexture")
                   .Read(resource::Depth)
                   .Read(resource::Normal)
                   .Write(Raw, raw);
  if (this->Method == Hemisphere)
  {
    this->DeclareHemisphere(sample, variant, radius, samplingDrawing);
  }
  else
  {
    this->DeclareHorizon(sample, variant, radius, thickness, samplingDrawing);
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
      .Write(FilteredRows, raw)
      .Draw("ambient_occlusion/filter.frag", rows, {}, samplingDrawing);
    input = FilteredRows;
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
  const Drawing finalDrawing = { true, 1, FullyOpen };
  frame.AddPass("ambient-occlusion-filter")
    .Read(input, "rawTexture")
    .Read(resource::Depth)
    .Write(stride > 1 ? Smoothed : resource::AmbientVisibility, stride > 1 ? raw : fullSize)
    .Draw(
      "ambient_occlusion/filter.frag", columns, {}, stride > 1 ? samplingDrawing : finalDrawing);
  if (stride > 1)
  {
    variant.erase("GI_AVERAGED");
    frame.AddPass("ambient-occlusion-upsample")
      .Read(Smoothed, "rawTexture")
      .Read(resource::Depth)
      .Read(resource::DepthCopy)
      .Read(resource::Normal)
      .Write(resource::AmbientVisibility, fullSize)
      .Draw("ambient_occlusion/upsample.frag", variant, {}, finalDrawing);
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
  const int stepsPerSide = std::max(1, this->Samples / (2 * slices));
  const int refinements = stepsPerSide / StepsPerRefinement;
  pass.Draw("ambient_occlusion/horizon.frag", variant,
    Arguments()
      .Set("slices", slices)
      .Set("steps", stepsPerSide - refinements)
      .Set("refinements", refinements)
      .Set("radius", radius)
      .Set("thickness", thickness),
    drawing);
}
