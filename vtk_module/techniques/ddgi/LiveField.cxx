// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/ddgi/LiveField.h"

#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderer.h"

#include <algorithm>
#include <limits>

namespace penumbra
{
namespace
{
// Distances are kept as they are after so many updates of geometry that stands still.
constexpr int AllDistances = 8;
constexpr int DistanceStride = 4;
constexpr int MostDistances = AllDistances + 64 * DistanceStride;

// For so many updates after a change each one's share stays as large as hysteresis lets it be: light bounces
// once in an update, so that much of a change takes several to arrive.
constexpr int Agile = 48;

// Meanwhile it is judged in one of so many updates where probes should stand, from a certain one on.
constexpr int Judgement = 8;
constexpr int FirstJudgement = 3;

// Of the next update, after so many since a change.
double ShareOf(int updates, double hysteresis)
{
  const double most = 1.0 - hysteresis;
  return updates < Agile ? most : 1.0 / (1.0 / most + 0.5 * (updates - Agile));
}

// How far off the eye that is which the camera looks at, within the scene.
double LooksAt(const View& view, vtkCamera* camera)
{
  const glm::dvec3 ahead = -glm::dvec3(view.ViewToWorld[2]);
  double leaves = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double wall = view.Bounds[2 * axis + (ahead[axis] > 0.0 ? 1 : 0)];
    const double slope = std::abs(ahead[axis]) > 1e-12 ? ahead[axis] : 1e-12;
    leaves = std::min(leaves, (wall - view.ViewToWorld[3][axis]) / slope);
  }
  return leaves > 0.0 ? std::min(camera->GetDistance(), leaves) : camera->GetDistance();
}

// How wide or high a part of the scene fills the picture there.
double ShownSize(const View& view, vtkCamera* camera)
{
  const glm::dvec2 size(view.Viewport.z, view.Viewport.w);
  const double wider = std::max(size.x / std::max(size.y, 1.0), 1.0);
  const double high = view.Parallel
    ? camera->GetParallelScale()
    : LooksAt(view, camera) * std::tan(0.5 * glm::radians(camera->GetViewAngle()));
  return 2.0 * high * wider;
}

glm::dvec3 PlaceLookedAt(const View& view, vtkCamera* camera)
{
  const glm::dvec3 low(view.Bounds[0], view.Bounds[2], view.Bounds[4]);
  const glm::dvec3 high(view.Bounds[1], view.Bounds[3], view.Bounds[5]);
  const glm::dvec3 ahead = -glm::dvec3(view.ViewToWorld[2]);
  return glm::clamp(glm::dvec3(view.ViewToWorld[3]) + LooksAt(view, camera) * ahead, low, high);
}
}

int LiveField::Settings::ProbesPerFrame(int most) const
{
  const int afforded = this->RaysBudget > 0 ? this->RaysBudget / this->Rays : most;
  return std::max(1, std::min(afforded, most));
}

void LiveField::Prepare(const View& view, const Settings& settings, vtkMTimeType parameters)
{
  this->Now = settings;
  const std::array<int, 2> asked = { settings.Probes, settings.Grids };
  if (view.StandsAlone || asked != this->Asked || !this->Grids().Get(0).Suits(view.Bounds))
  {
    *this = LiveField();
    this->Now = settings;
    this->Asked = asked;
    this->MakeGrids(view);
  }
  const SceneChanges& changes = view.Changes;
  if (changes.Lights || changes.Props || changes.Appearance || this->Parameters != parameters)
  {
    this->Known = this->Done = 0;
  }
  if (changes.Props)
  {
    this->Seen = std::min(this->Seen, AllDistances);
    this->Looked = std::min(this->Looked, AllDistances);
    this->Moved = true;
    this->Unconnected = this->Grids().Size();
  }
  this->Parameters = parameters;
}

void LiveField::MakeGrids(const View& view)
{
  const int probes = this->Now.Probes / this->Now.Grids;
  this->Nested = NestedGrids(ProbeGrid::Around(view.Bounds, probes), this->Now.Grids, probes);
  this->Update.Uniforms.Grids = this->Nested.List();
}

void LiveField::Follow(Frame& frame)
{
  NestedGrids& grids = this->Nested;
  const View& view = frame.GetView();
  vtkCamera* camera = frame.GetRenderer()->GetActiveCamera();
  const bool fixed = this->Now.Refinement > 0.0;
  const bool others =
    grids.Refine(fixed ? std::max(this->Now.Refinement, NestedGrids::LeastRefinement)
                       : grids.RefinementFor(ShownSize(view, camera)));
  const glm::dvec3 looked = PlaceLookedAt(view, camera);
  for (int number = 1; number < grids.Count(); ++number)
  {
    const ProbeGrid grid = grids.Get(number);
    const glm::ivec3 moved = grids.Follow(number, looked, this->Unknown || others);
    this->Update.Uniforms.Grids = grids.List();
    if (!this->Unknown && (others || moved != glm::ivec3(0)))
    {
      this->Update.Scroll(frame, this->Textures, number, others ? grid.Counts : moved);
      this->Done = 0;
      this->Looked = std::min(this->Looked, AllDistances);
      this->Unconnected = this->Grids().Size();
    }
  }
}

void LiveField::AddUpdates(Frame& frame, RayProps& rays, LightTable& lights)
{
  const int size = this->Grids().Size();
  this->Textures = LiveProbeMaps::Of(frame, size, this->Now.Rays);
  this->Unknown |= this->Textures.AreFresh();
  if (this->Unknown)
  {
    this->Textures.Clear(frame);
    this->Next = this->Total = this->Known = this->Done = this->Seen = this->Looked = 0;
    this->Unconnected = size;
  }
  this->Trace(frame, rays, lights);
  if (!frame.GetView().StandsAlone)
  {
    this->Blend(frame);
    return;
  }
  // No frame follows in which light could arrive. What comes after these updates averages noise.
  const int updates = std::min(this->Now.Updates, Agile);
  while (this->Done < updates - 1 || (this->Done < updates && !this->IsLastPart()))
  {
    this->Blend(frame);
    this->Trace(frame, rays, lights);
  }
  this->Blend(frame);
}

void LiveField::Trace(Frame& frame, RayProps& rays, LightTable& lights)
{
  const int size = this->Grids().Size();
  LiveProbeUpdate& update = this->Update;
  update.Uniforms.Origin = rays.Origin();
  update.Uniforms.Bias = this->Now.Bias;
  update.Rays = &rays;
  update.Lights = &lights;
  update.RayCount = this->Now.Rays;
  update.Number = this->Total;
  update.First = this->Next;
  update.Last = this->Next + this->Now.ProbesPerFrame(size - this->Next);
  this->Follow(frame);
  this->Unknown = false;
  if (this->Rests())
  {
    return;
  }
  const bool judged = this->Next == 0 && this->Total % Judgement == FirstJudgement &&
    this->Done < Agile && this->Now.Relocate;
  if (judged)
  {
    update.Relocate(frame, this->Textures, this->Moved);
    this->Moved = false;
    update.Connect(frame, this->Textures, 0, size);
    this->Unconnected = 0;
  }
  if (this->Unconnected > 0)
  {
    update.Connect(frame, this->Textures, update.First, update.Last);
    this->Unconnected -= update.Last - update.First;
  }
  update.Trace(frame, this->Textures);
}

void LiveField::Blend(Frame& frame)
{
  if (this->Rests())
  {
    return;
  }
  // After the first updates, a few of the probes at a time: distances take long to blend.
  const bool all = this->Seen < AllDistances;
  const int seen = all ? this->Seen : AllDistances + (this->Seen - AllDistances) / DistanceStride;
  const int stride = all ? 1 : (this->Looked < MostDistances ? DistanceStride : 0);
  this->Update.BlendDistances(frame, this->Textures, seen, stride);
  this->Update.BlendLight(frame, this->Textures, ShareOf(this->Known, this->Now.Hysteresis));
  this->Advance();
}

// After a frame's probes, to the next; after the last, the update is done.
void LiveField::Advance()
{
  this->Next = this->Update.Last;
  if (this->Next >= this->Grids().Size())
  {
    this->Next = 0;
    ++this->Total;
    ++this->Known;
    ++this->Done;
    ++this->Seen;
    ++this->Looked;
  }
}
}
