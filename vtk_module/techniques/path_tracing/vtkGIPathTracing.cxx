// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIPathTracing.h"

#include "base/Luminance.h"
#include "capture/MaterialTable.h"
#include "capture/SceneCapture.h"
#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"
#include "technique/StillFrames.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGIPass.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

vtkStandardNewMacro(vtkGIPathTracing);

using namespace penumbra;

vtkGIPathTracing::vtkGIPathTracing() = default;
vtkGIPathTracing::~vtkGIPathTracing() = default;

namespace
{
// Order among the passes that modify the picture: before anti-aliasing.
constexpr int TraceOrder = 700;
constexpr int FilteredOrder = 701;

constexpr std::size_t SumCount = 5;
constexpr std::array<const char*, SumCount> SumNames = { { "path-tracing.shown",
  "path-tracing.encoded", "path-tracing.albedo", "path-tracing.normal", "path-tracing.unlit" } };

constexpr std::array<const char*, SumCount> SumImages = { { "sumShown", "sumEncoded", "sumAlbedo",
  "sumNormal", "sumUnlit" } };

constexpr const char* ShowShader = "path_tracing/show.frag";

// Sums of what lit surfaces show without chance, which is not to be filtered. They are no part of saved progress: a mean over
// fewer samples will do, which are traced at once then.
constexpr std::size_t CertainCount = 2;
constexpr std::array<const char*, CertainCount> CertainNames = { { "path-tracing.certain",
  "path-tracing.fine" } };
constexpr std::array<const char*, CertainCount> CertainImages = { { "sumCertain", "sumFine" } };
constexpr int MostCertainAtOnce = 16;

// Number of samples after which neither these values nor the filter change the picture.
constexpr int LastFiltered = 256;

// Jitter of a sample, in pixels: Sobol's (0, 2)-sequence (1967). The digital shift by 0.1010... puts points into the middle of
// their strata, whatever the number of samples; the error of edges with 16 samples is 0.6 of that of Halton's sequence.
// Directions are points of the same sequence, but in another order in each pixel.
glm::dvec2 SampleShift(int index)
{
  constexpr unsigned shift = 0xaaaaaaaaU;
  glm::uvec2 point(0U);
  glm::uvec2 columns(1U << 31U);
  for (auto digits = static_cast<unsigned>(index); digits != 0U; digits >>= 1U)
  {
    point ^= (digits & 1U) * columns;
    columns = { columns.x >> 1U, columns.y ^ (columns.y >> 1U) };
  }
  return index > 0 ? glm::dvec2(point ^ shift) / 4294967296.0 - 0.5 : glm::dvec2(0.0);
}
}

struct penumbra::PathTracer
{
  RayProps* Rays;
  LightTable* Lights;
  std::array<History*, SumCount> Sums;
  std::array<History*, CertainCount> Certain = {}; ///< only if light is filtered

  bool HasEmptySums() const
  {
    return std::any_of(
      this->Sums.begin(), this->Sums.end(), [](const History* sum) { return !sum->Written; });
  }

  /// Copy the sums of an image to the GPU. Returns false if the image has another size.
  bool Restore(vtkImageData* image) const
  {
    int size[3];
    image->GetDimensions(size);
    const TextureDesc& desc = this->Sums[0]->Storage.Desc();
    if (size[0] != desc.Width || size[1] != desc.Height)
    {
      return false;
    }
    for (std::size_t i = 0; i < this->Sums.size(); ++i)
    {
      glBindTexture(GL_TEXTURE_2D, this->Sums[i]->Storage.Get());
      glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size[0], size[1], GL_RGBA, GL_FLOAT,
        image->GetPointData()->GetArray(SumNames[i])->GetVoidPointer(0));
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    return true;
  }

  /// Add one path per pixel to the sums of the pass. sampleIndex: number of paths so far.
  void Trace(FrameContext& context, int sampleIndex, int seed) const
  {
    this->Trace(context, "path_tracing/trace.comp", sampleIndex, seed, Arguments());
  }

  /// Add what the same paths meet first to the sums of the pass. samples: number of samples in those so far. earlier: whether
  /// the paths are those of an earlier frame.
  void TraceCertain(
    FrameContext& context, int sampleIndex, int seed, int samples, bool earlier) const
  {
    const glm::dvec2 jitter = context.GetView().Jitter;
    const glm::vec2 shift = earlier ? jitter - SampleShift(sampleIndex) : glm::dvec2(0.0);
    this->Trace(context, "path_tracing/certain.comp", sampleIndex, seed,
      Arguments()
        .Set("certainSamples", samples)
        .Set("shift", shift)
        .Set("jitter", glm::vec2(jitter)));
  }

  void Trace(
    FrameContext& context, const char* shader, int sampleIndex, int seed, Arguments arguments) const
  {
    // Without lights VTK draws surfaces as flat colours, which the capture cannot tell from lines. Rays then have to
    // reach slightly beyond the drawn depth, so that they find these surfaces.
    constexpr double margin = 1e-3;
    context.Dispatch(shader, this->Rays->ShaderDefines(),
      arguments.Set("sampleIndex", sampleIndex)
        .Set("seedOfAll", seed)
        .Set("drawnReach", this->Lights->Lights().empty() ? 1.0 + margin : 1.0 - margin),
      Work::Items(context.GetView().Viewport.z, context.GetView().Viewport.w));
  }

  void Read(FrameContext& context, int number, std::vector<float>& values) const
  {
    const Texture& sum = this->Sums[static_cast<std::size_t>(number)]->Storage;
    context.GetCommands().BeforeUse(sum, GL_TEXTURE_UPDATE_BARRIER_BIT);
    glBindTexture(GL_TEXTURE_2D, sum.Get());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, values.data());
    glBindTexture(GL_TEXTURE_2D, 0);
  }

  /// Standard error of the pixels' mean luminance values, relative to the picture's mean luminance.
  double EstimateError(FrameContext& context, int samples) const
  {
    const glm::ivec2 size = context.GetView().WindowSize;
    std::vector<float> shown(4 * static_cast<std::size_t>(size.x) * size.y);
    std::vector<float> encoded(shown.size());
    this->Read(context, 0, shown);
    this->Read(context, 1, encoded);
    double variances = 0.0;
    double total = 0.0;
    const glm::ivec4& area = context.GetView().Viewport;
    for (int y = area.y; y < area.y + area.w; ++y)
    {
      for (int x = area.x; x < area.x + area.z; ++x)
      {
        const std::size_t i = 4 * (static_cast<std::size_t>(y) * size.x + x);
        const double mean = Luminance(shown[i] + encoded[i], shown[i + 1] + encoded[i + 1],
                              shown[i + 2] + encoded[i + 2]) /
          samples;
        variances += std::max(0.0, encoded[i + 3] / samples - mean * mean) / (samples - 1);
        total += mean;
      }
    }
    const double pixels = static_cast<double>(area.z) * area.w;
    return total > 0.0 ? std::sqrt(variances / pixels) / (total / pixels) : 0.0;
  }

  /// Draw the mean. The sums are given as textures, because the tracing pass declares them as images.
  void Show(FrameContext& context, int samples) const
  {
    context.Draw(ShowShader, {},
      Arguments()
        .Sample("sumShown", &this->Sums[0]->Storage)
        .Sample("sumEncoded", &this->Sums[1]->Storage)
        .Sample("sumAlbedo", &this->Sums[2]->Storage)
        .Sample("sumUnlit", &this->Sums[4]->Storage)
        .Set("samples", static_cast<double>(samples)));
  }

  /// Have a pass know what paths need.
  PassDeclaration& DeclareTracing(FrameBuilder& frame, PassDeclaration& pass) const
  {
    return pass.Read(resource::Albedo)
      .Read(resource::Normal)
      .Read(resource::DepthCopy)
      .ReadIfPresent(resource::Sky, "GI_VISIBLE_SKY")
      .Offer(this->Rays->ShaderArguments())
      .Offer(frame.Capture().Materials().ShaderArguments())
      .Offer(frame.Lights().InWorld(this->Rays->Origin()))
      .Offer(frame.GetView().ToScene(this->Rays->Origin()));
  }

  /// Add a pass that draws from the sums after the samples of a frame.
  PassDeclaration& AddDrawing(FrameBuilder& frame, const std::string& name, const char* shader,
    const Defines& variant, const int& samples) const
  {
    auto& pass = frame.AddPass(name);
    for (std::size_t i = 0; i < this->Sums.size(); ++i)
    {
      pass.ReadHistory(*this->Sums[i], SumImages[i]);
    }
    for (std::size_t i = 0; i < this->Certain.size() && this->Certain[i]; ++i)
    {
      pass.ReadHistory(*this->Certain[i], CertainImages[i]);
    }
    return pass.ReadIfPresent(resource::Sky, "GI_VISIBLE_SKY")
      .Offer(frame.GetView().ToScene(this->Rays->Origin()))
      .Execute([shader, variant, &samples](FrameContext& context) {
        context.Draw(shader, variant, Arguments().Set("samples", static_cast<double>(samples)));
      });
  }
};

struct vtkGIPathTracing::Progress
{
  int Samples = 0;
  int CertainSamples = 0; ///< in what surfaces show without chance
  bool Traced = false; ///< whether the frame added a sample
  double Error = HUGE_VAL;
};

const vtkGIPathTracing::Progress* vtkGIPathTracing::Find(vtkRenderer* renderer) const
{
  const ViewState* view = this->Views ? this->Views->FindView(renderer) : nullptr;
  return view ? view->Find<Progress>(this) : nullptr;
}

int vtkGIPathTracing::GetSamplesTaken(vtkRenderer* renderer)
{
  const Progress* progress = this->Find(renderer);
  return progress ? progress->Samples : 0;
}

double vtkGIPathTracing::GetRelativeError(vtkRenderer* renderer)
{
  const Progress* progress = this->Find(renderer);
  return progress ? progress->Error : HUGE_VAL;
}

bool vtkGIPathTracing::GetProgress(vtkGIPass* pass, vtkRenderer* renderer, vtkImageData* image)
{
  const int samples = this->GetSamplesTaken(renderer);
  if (!pass || !image || samples == 0)
  {
    return false;
  }
  vtkNew<vtkImageData> sums;
  for (const char* name : SumNames)
  {
    vtkNew<vtkImageData> sum;
    if (!pass->GetBuffer(renderer, name, sum))
    {
      return false;
    }
    sum->GetPointData()->GetScalars()->SetName(name);
    sums->SetDimensions(sum->GetDimensions());
    sums->GetPointData()->AddArray(sum->GetPointData()->GetScalars());
  }
  vtkNew<vtkIntArray> count;
  count->SetName("samples");
  count->InsertNextValue(samples);
  sums->GetFieldData()->AddArray(count);
  image->ShallowCopy(sums);
  return true;
}

bool vtkGIPathTracing::SetProgress(vtkRenderer* renderer, vtkImageData* image)
{
  vtkDataArray* count = image ? image->GetFieldData()->GetArray("samples") : nullptr;
  bool complete =
    renderer && count && count->GetNumberOfValues() == 1 && count->GetComponent(0, 0) >= 1.0;
  for (std::size_t i = 0; complete && i < SumNames.size(); ++i)
  {
    auto* sum = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(SumNames[i]));
    complete = sum && sum->GetNumberOfComponents() == 4 &&
      sum->GetNumberOfTuples() == image->GetNumberOfPoints();
  }
  if (complete)
  {
    // Keep the arrays, because the caller may put others into the image.
    auto resumed = vtkSmartPointer<vtkImageData>::New();
    resumed->ShallowCopy(image);
    this->TakePendingProgress(renderer); // replaces an earlier one
    this->PendingProgress.emplace_back(renderer, resumed);
  }
  return complete;
}

bool vtkGIPathTracing::IsFinished(const Progress& progress) const
{
  // A target of 0 takes all samples, even if the estimated error is 0.
  return progress.Samples >= this->Samples ||
    (this->TargetError > 0.0 && progress.Error <= this->TargetError);
}

bool vtkGIPathTracing::IsFinished(vtkRenderer* renderer)
{
  const Progress* progress = this->Find(renderer);
  return progress && this->IsFinished(*progress);
}

void vtkGIPathTracing::Plan(LightingPlan& plan, FrameBuilder&)
{
  plan.DrawByRays();
}

vtkSmartPointer<vtkImageData> vtkGIPathTracing::TakePendingProgress(vtkRenderer* renderer)
{
  vtkSmartPointer<vtkImageData> resumed;
  for (auto it = this->PendingProgress.begin(); it != this->PendingProgress.end();)
  {
    resumed = it->first == renderer ? it->second : resumed;
    it = it->first && it->first != renderer ? std::next(it) : this->PendingProgress.erase(it);
  }
  return resumed;
}

void vtkGIPathTracing::Contribute(FrameBuilder& frame)
{
  RayProps& rays = frame.Rays("they are drawn without global illumination");
  Progress& progress = frame.ViewState<Progress>(this);
  const vtkSmartPointer<vtkImageData> resumed = this->TakePendingProgress(frame.GetRenderer());
  if (frame.GetView().StillFrames == 0 || resumed)
  {
    progress = Progress();
  }
  if (resumed)
  {
    progress.Samples =
      static_cast<int>(resumed->GetFieldData()->GetArray("samples")->GetComponent(0, 0));
  }
  PathTracer tracer = { &rays, &frame.Lights(), {} };
  ShiftStillFrame(frame, SampleShift(this->IsFinished(progress) ? 0 : progress.Samples));
  auto& pass = frame.AddPass("path-trace");
  for (std::size_t i = 0; i < tracer.Sums.size(); ++i)
  {
    tracer.Sums[i] = &frame.Keep(SumNames[i], frame.WindowTexture(GL_RGBA32F));
    pass.UpdateHistory(*tracer.Sums[i], SumImages[i]);
  }
  tracer.DeclareTracing(frame, pass)
    .Modify(resource::Color, TraceOrder)
    .Execute([this, &current = progress, tracer, resumed](FrameContext& context) {
      if (resumed ? !tracer.Restore(resumed) : tracer.HasEmptySums())
      {
        current = Progress();
      }
      current.Traced = !this->IsFinished(current);
      if (current.Traced)
      {
        tracer.Trace(context, current.Samples, this->Seed);
        ++current.Samples;
        // Interval of about an eighth of the samples so far: it stops soon enough and costs little.
        constexpr int block = 8;
        const int interval = std::max(block, current.Samples / block / block * block);
        const bool updateError = current.Samples > block && current.Samples % interval == 0;
        current.Error =
          updateError ? tracer.EstimateError(context, current.Samples) : current.Error;
      }
      tracer.Show(context, current.Samples);
    });
  if (frame.Plan().FiltersNoise())
  {
    for (std::size_t i = 0; i < tracer.Certain.size(); ++i)
    {
      tracer.Certain[i] = &frame.Keep(CertainNames[i], frame.WindowTexture(GL_RGBA32F));
    }
    this->AddSignal(frame, tracer, progress);
  }
  const Defines radiance = { { "GI_RADIANCE", "1" } };
  tracer.AddDrawing(frame, "path-trace-radiance", ShowShader, radiance, progress.Samples)
    .ReadIfPresent(resource::PathLight, "GI_FILTERED")
    .ModifyIfPresent(resource::Radiance, TraceOrder);
  if (frame.Plan().HasLitParts())
  {
    const Defines parts = { { "GI_LIT_PARTS", "1" } };
    tracer.AddDrawing(frame, "path-trace-lit", ShowShader, parts, progress.Samples)
      .ReadIfPresent(resource::PathLight, "GI_FILTERED")
      .Modify(resource::LitShown, TraceOrder)
      .Modify(resource::LitEncoded, TraceOrder);
  }
}

void vtkGIPathTracing::AddSignal(FrameBuilder& frame, const PathTracer& tracer, Progress& progress)
{
  auto& pass = frame.AddPass("path-trace-certain");
  for (std::size_t i = 0; i < tracer.Certain.size(); ++i)
  {
    pass.UpdateHistory(*tracer.Certain[i], CertainImages[i]);
  }
  tracer.DeclareTracing(frame, pass)
    .ReadHistory(*tracer.Sums[0], SumImages[0]) // after the paths
    .Execute([this, tracer, &progress](FrameContext& context) {
      progress.CertainSamples = tracer.Certain[0]->Written ? progress.CertainSamples : 0;
      const bool isNew = progress.CertainSamples == 0;
      const int end = isNew ? std::min(progress.Samples, MostCertainAtOnce) : progress.Samples;
      const bool more = progress.Traced && progress.Samples <= LastFiltered;
      for (int i = isNew ? 0 : end - 1; (isNew || more) && i < end; ++i)
      {
        const bool earlier = !progress.Traced || i < progress.Samples - 1;
        tracer.TraceCertain(context, i, this->Seed, progress.CertainSamples++, earlier);
      }
    });
  const TextureDesc floats = frame.WindowTexture(GL_RGBA32F);
  tracer.AddDrawing(frame, "path-trace-signal", "path_tracing/signal.frag", {}, progress.Samples)
    .Write(resource::PathLight, floats)
    .Write(resource::PathSurface, floats);
  tracer.AddDrawing(frame, "path-trace-filtered", ShowShader, {}, progress.Samples)
    .ReadIfPresent(resource::PathLight, "GI_FILTERED")
    .Modify(resource::Color, FilteredOrder);
}
