// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkGIPass's implementation that times frames and keeps to their budget.
#include "pass/PassInternals.h"

#include "vtkOpenGLRenderer.h"
#include "vtkRendererCollection.h"

#include <nlohmann/json.hpp>

#include <chrono>

using namespace penumbra;

namespace
{
// The budget is the window's: renderers that share a pass share it, and so do both eyes.
int PicturesOf(vtkGIPass* pass, vtkRenderWindow* window)
{
  int count = 0;
  vtkCollectionSimpleIterator cookie;
  vtkRendererCollection* renderers = window->GetRenderers();
  renderers->InitTraversal(cookie);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(cookie))
  {
    count += renderer->GetPass() == pass && renderer->GetDraw() ? 1 : 0;
  }
  const int type = window->GetStereoType();
  const bool bothEyes =
    window->GetStereoRender() && type != VTK_STEREO_LEFT && type != VTK_STEREO_RIGHT;
  return std::max(count, 1) * (bothEyes ? 2 : 1);
}
}

void vtkGIPass::Internals::BeginTimes(ViewRecord& record, bool wanted)
{
  this->Timed = wanted ? &record : nullptr;
  if (!wanted)
  {
    this->LastTimed = this->LastTimed == &record ? nullptr : this->LastTimed;
    record.Timer.reset();
    return;
  }
  if (!record.Timer)
  {
    record.Timer.emplace();
  }
  this->TakeTimes(record, record.Timer->Collect());
  this->ProgramsBefore = this->Shaders.NumberOfPrograms();
  record.Timer->BeginFrame(record.FrameNumber);
}

void vtkGIPass::Internals::ApplyBudget(
  vtkGIPass* self, vtkOpenGLRenderer* renderer, ViewRecord& record, View& view)
{
  const double budget = self->CurrentFrameBudget(renderer->GetRenderWindow());
  if (budget == 0.0 && record.Budget.CurrentState() == FrameBudget::State::Off)
  {
    return;
  }
  const std::chrono::duration<double, std::milli> now =
    std::chrono::steady_clock::now().time_since_epoch();
  FrameBudget::Situation situation;
  situation.Budget = budget / PicturesOf(self, renderer->GetRenderWindow());
  situation.Exempt = view.StandsAlone || WholePicture::IsTile(renderer);
  situation.Still = self->GetStillPicture();
  situation.Changed = view.Changes.Any;
  situation.SceneChanged = view.Changes.Presence || view.Changes.Appearance;
  situation.Pixels = double(view.Viewport.z) * view.Viewport.w;
  situation.ClockTime = now.count();
  this->Governed = &record;
  if (record.Budget.Begin(this->Techniques, situation, record.FrameNumber))
  {
    record.StillFrames = 0;
    view.StillFrames = 0;
    view.Sequence = 0;
  }
}

void vtkGIPass::Internals::ShareBudget(vtkGIPass* self, vtkRenderer* renderer,
  const std::function<void(double* values, int count)>& maximum)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (this->Guard->Window())
  {
    this->Guard->Window()->MakeCurrent();
  }
  ViewRecord& record = this->FindOrAddRecord(renderer);
  if (record.Timer && this->Guard->Window())
  {
    this->TakeTimes(record, record.Timer->Collect());
  }
  int width = 0;
  int height = 0;
  renderer->GetTiledSize(&width, &height);
  FrameBudget::Situation situation;
  situation.Budget = self->CurrentFrameBudget(window) / PicturesOf(self, window);
  situation.Pixels = static_cast<double>(width) * height;
  std::vector<double> values = record.Budget.Offer(this->Techniques, situation);
  maximum(values.data(), static_cast<int>(values.size()));
  record.Budget.Accept(this->Techniques, values);
}

void vtkGIPass::Internals::PutSettingsBack()
{
  if (this->Governed)
  {
    this->Governed->Budget.End();
    this->Governed = nullptr;
  }
}

void vtkGIPass::Internals::EndFrame()
{
  this->PutSettingsBack();
  if (this->Timed)
  {
    this->Timed->Timer->Mark("other-props");
    this->Timed->Timer->EndFrame();
    if (this->Shaders.NumberOfPrograms() != this->ProgramsBefore)
    {
      this->Timed->Budget.Ignore(this->Timed->FrameNumber - 1); // compiling took most of its time
    }
    this->LastTimed = this->Timed;
    this->Timed = nullptr;
  }
}

void vtkGIPass::Internals::TakeTimes(ViewRecord& record, std::vector<TimedFrame> frames)
{
  for (TimedFrame& frame : frames)
  {
    record.Budget.Measure(frame);
    record.Statistics.Add(std::move(frame), this->Techniques);
  }
}

const std::string& vtkGIPass::Internals::ReadStatistics()
{
  this->StatisticsText = "{}";
  if (!this->LastTimed)
  {
    return this->StatisticsText;
  }
  ViewRecord& record = *this->LastTimed;
  if (record.Timer && this->Guard->Window())
  {
    this->Guard->Window()->MakeCurrent();
    this->TakeTimes(record, record.Timer->Wait());
  }
  const bool governed = record.Budget.CurrentState() != FrameBudget::State::Off;
  this->StatisticsText = record.Statistics.ToText(
    this->Techniques, governed ? record.Budget.Describe() : nlohmann::ordered_json());
  return this->StatisticsText;
}
