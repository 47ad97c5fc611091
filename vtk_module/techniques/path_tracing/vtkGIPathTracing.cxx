// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIPathTracing.h"

#include "capture/MaterialTable.h"
#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
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
// Among the passes that modify the picture: before anti-aliasing.
constexpr int TraceOrder = 700;
constexpr const char* Traced = "path-tracing.traced"; // orders the passes that show the sums

constexpr std::array<const char*, 4> SumNames = { { "path-tracing.shown", "path-tracing.encoded",
  "path-tracing.albedo", "path-tracing.normal" } };

struct PathTracer
{
  RayProps* Rays;
  LightTable* Lights;
  MaterialTable* Materials;
  int Bounces;
  int Strategy;
  /// fresh: they were made just now and hold nothing.
  static std::array<Texture*, 4> Sums(FrameContext& context, bool* fresh = nullptr)
  {
    const View& view = context.GetView();
    std::array<Texture*, 4> sums = {};
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      bool made = false;
      sums[i] = &context.History(
        SumNames[i], { GL_RGBA32F, view.WindowSize.x, view.WindowSize.y, 0 }, made);
      *(fresh ? fresh : &made) |= made;
    }
    return sums;
  }

  /// False where the image has another size.
  bool Restore(FrameContext& context, vtkImageData* image) const
  {
    const auto sums = this->Sums(context);
    int size[3];
    image->GetDimensions(size);
    if (size[0] != sums[0]->Desc().Width || size[1] != sums[0]->Desc().Height)
    {
      return false;
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      glBindTexture(GL_TEXTURE_2D, sums[i]->Get());
      glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size[0], size[1], GL_RGBA, GL_FLOAT,
        image->GetPointData()->GetArray(SumNames[i])->GetVoidPointer(0));
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    return true;
  }

  /// taken: samples in the sums already.
  void Trace(FrameContext& context, int taken) const
  {
    const View& view = context.GetView();
    const auto sums = this->Sums(context);
    for (GLuint unit = 0; unit < sums.size(); ++unit)
    {
      glBindImageTexture(unit, sums[unit]->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    }
    Defines defines = this->Rays->ShaderDefines();
    const Texture* sky = context.Input(resource::Sky);
    if (sky)
    {
      defines["GI_VISIBLE_SKY"] = "1";
    }
    const Program& program = context.Shaders().Compute("path_tracing/trace.comp", defines);
    context.Use(program,
      { context.Input(resource::Albedo), context.Input(resource::Normal),
        context.Input(resource::WindowDepth), context.Input(resource::Color), sky });
    this->Rays->Bind(program);
    this->Materials->Bind(1);
    this->Lights->BindWorld(0, this->Rays->Origin());
    const glm::mat3 rotation(glm::dmat3(view.ViewToWorld));
    const glm::vec3 eye(glm::dvec3(view.ViewToWorld[3]) - this->Rays->Origin());
    glUniformMatrix3fv(program.Location("viewToScene"), 1, GL_FALSE, &rotation[0][0]);
    glUniform3fv(program.Location("eye"), 1, &eye[0]);
    glUniform1i(program.Location("sampleIndex"), taken);
    glUniform1i(program.Location("bounces"), this->Bounces);
    glUniform1i(program.Location("strategy"), this->Strategy);
    glUniform1i(program.Location("lightCount"), static_cast<GLint>(this->Lights->Lights().size()));
    glUniform1i(program.Location("emitterCount"), static_cast<GLint>(this->Rays->EmitterCount()));
    // Without lights VTK draws surfaces as flat colours, which look like lines to us: rays see them.
    constexpr float margin = 1e-3f;
    glUniform1f(program.Location("drawnReach"),
      this->Lights->Lights().empty() ? 1.0f + margin : 1.0f - margin);
    constexpr int group = 8;
    glDispatchCompute(
      (view.Viewport.z + group - 1) / group, (view.Viewport.w + group - 1) / group, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  }

  /// Relative standard error of the picture's mean luminance values, of this many samples.
  double EstimateError(FrameContext& context, int samples) const
  {
    const auto sums = this->Sums(context);
    const glm::ivec2 size = context.GetView().WindowSize;
    std::vector<float> shown(4 * static_cast<std::size_t>(size.x) * size.y);
    std::vector<float> encoded(shown.size());
    glBindTexture(GL_TEXTURE_2D, sums[0]->Get());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, shown.data());
    glBindTexture(GL_TEXTURE_2D, sums[1]->Get());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, encoded.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    double squares = 0.0;
    double total = 0.0;
    const glm::ivec4& area = context.GetView().Viewport;
    for (int y = area.y; y < area.y + area.w; ++y)
    {
      for (int x = area.x; x < area.x + area.z; ++x)
      {
        const std::size_t at = 4 * (static_cast<std::size_t>(y) * size.x + x);
        const double mean =
          (0.2126 * (shown[at] + encoded[at]) + 0.7152 * (shown[at + 1] + encoded[at + 1]) +
            0.0722 * (shown[at + 2] + encoded[at + 2])) /
          samples;
        squares += std::max(0.0, encoded[at + 3] / samples - mean * mean) / (samples - 1);
        total += mean;
      }
    }
    const double pixels = static_cast<double>(area.z) * area.w;
    return total > 0.0 ? std::sqrt(squares / pixels) / (total / pixels) : 0.0;
  }

  void Show(FrameContext& context, const char* target, int samples) const
  {
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, false);
    scope.DepthMask(false);
    Defines defines;
    if (target == resource::Radiance)
    {
      defines["GI_RADIANCE"] = "1";
    }
    const auto sums = this->Sums(context);
    const Program& program = context.Shaders().Fragment("path_tracing/show.frag", defines);
    context.BindTarget({ target });
    context.Use(program, { sums[0], sums[1], context.Input(target) });
    glUniform1f(program.Location("samples"), static_cast<float>(samples));
    context.DrawFullscreen();
  }
};
}

struct vtkGIPathTracing::Progress
{
  int Samples = 0;
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
  bool whole =
    renderer && count && count->GetNumberOfValues() == 1 && count->GetComponent(0, 0) >= 1.0;
  for (std::size_t i = 0; whole && i < SumNames.size(); ++i)
  {
    auto* sum = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(SumNames[i]));
    whole = sum && sum->GetNumberOfComponents() == 4 &&
      sum->GetNumberOfTuples() == image->GetNumberOfPoints();
  }
  if (whole)
  {
    // The arrays, not the image, which may come to hold something else.
    auto taken = vtkSmartPointer<vtkImageData>::New();
    taken->ShallowCopy(image);
    this->TakeUp(renderer); // an earlier one is forgotten
    this->ToTakeUp.emplace_back(renderer, taken);
  }
  return whole;
}

bool vtkGIPathTracing::IsFinished(const Progress& progress) const
{
  // A target of 0 spends all samples, even where those so far are all alike.
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

vtkSmartPointer<vtkImageData> vtkGIPathTracing::TakeUp(vtkRenderer* renderer)
{
  vtkSmartPointer<vtkImageData> taken;
  for (auto it = this->ToTakeUp.begin(); it != this->ToTakeUp.end();)
  {
    taken = it->first == renderer ? it->second : taken;
    it = it->first && it->first != renderer ? std::next(it) : this->ToTakeUp.erase(it);
  }
  return taken;
}

void vtkGIPathTracing::Contribute(FrameBuilder& frame)
{
  RayProps& rays = frame.Rays();
  if (rays.LeftOut() > 0)
  {
    frame.AddNote("rays do not see " + std::to_string(rays.LeftOut()) +
      " props of kinds that cannot be traced yet: they are drawn without global illumination");
  }
  Progress& progress = frame.ViewState<Progress>(this);
  const vtkSmartPointer<vtkImageData> taken = this->TakeUp(frame.GetRenderer());
  if (frame.GetView().StillFrames == 0 || taken)
  {
    progress = Progress();
  }
  if (taken)
  {
    progress.Samples =
      static_cast<int>(taken->GetFieldData()->GetArray("samples")->GetComponent(0, 0));
  }
  const PathTracer tracer = { &rays, &frame.Lights(), &frame.Capture().Materials(), this->Bounces,
    this->Strategy };
  ShiftStillFrame(frame, this->IsFinished(progress) ? 0 : progress.Samples);
  frame.AddPass("path-trace")
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::WindowDepth)
    .ReadIfPresent(resource::Sky)
    .Modify(resource::Color, TraceOrder)
    .Write(Traced, { GL_R8, 1, 1, 0 })
    .Execute([this, &now = progress, tracer, taken](FrameContext& context) {
      bool fresh = false;
      PathTracer::Sums(context, &fresh);
      if (taken ? !tracer.Restore(context, taken) : fresh)
      {
        now = Progress();
      }
      if (!this->IsFinished(now))
      {
        tracer.Trace(context, now.Samples);
        ++now.Samples;
        // Often enough to stop in time, seldom enough to cost little.
        constexpr int block = 8;
        const int interval = std::max(block, now.Samples / block / block * block);
        const bool estimates = now.Samples > block && now.Samples % interval == 0;
        now.Error = estimates ? tracer.EstimateError(context, now.Samples) : now.Error;
      }
      tracer.Show(context, resource::Color, now.Samples);
    });
  frame.AddPass("path-trace-radiance")
    .Read(Traced)
    .ModifyIfPresent(resource::Radiance, TraceOrder)
    .Execute([&progress, tracer](FrameContext& context) {
      tracer.Show(context, resource::Radiance, progress.Samples);
    });
}
