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
// Number of distance updates of all probes after geometry changed. From then on one probe in
// DistanceStride is updated at a time, and after the maximum none.
constexpr int InitialDistanceUpdates = 8;
constexpr int DistanceStride = 4;
constexpr int MaximumDistanceUpdates = InitialDistanceUpdates + 64 * DistanceStride;

// Number of updates after a change in which the share of each stays as large as hysteresis allows. Light bounces once
// per part of an update, so a change takes several parts to arrive. Only these updates are done in parts.
constexpr int AdaptationUpdates = 6;

// Number of updates that count at most when a grid moves: the others hear what its new probes find.
constexpr int UpdatesOnTheMove = 12;

// Number of updates in a frame that stands alone.
constexpr int LoneUpdates = 24;

// Probes are relocated in one of this many updates, from the given one on, until so many are done after a change.
constexpr int RelocationInterval = 8;
constexpr int FirstRelocation = 3;
constexpr int LastRelocation = 48;

// Share of the next update in the probes' light, after a number of updates since a change.
double BlendShare(int updates, double hysteresis)
{
  const double maximum = 1.0 - hysteresis;
  return updates < AdaptationUpdates ? maximum
                                     : 1.0 / (1.0 / maximum + 0.5 * (updates - AdaptationUpdates));
}

// Distance from the eye to the camera's focal point, at most to where the line of sight leaves the scene.
double FocusDistance(const View& view, vtkCamera* camera)
{
  const glm::dvec3 ahead = -glm::dvec3(view.ViewToWorld[2]);
  double exit = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double bound = view.Bounds[2 * axis + (ahead[axis] > 0.0 ? 1 : 0)];
    const double slope = std::abs(ahead[axis]) > 1e-12 ? ahead[axis] : 1e-12;
    exit = std::min(exit, (bound - view.ViewToWorld[3][axis]) / slope);
  }
  return exit > 0.0 ? std::min(camera->GetDistance(), exit) : camera->GetDistance();
}

// Larger side of the part of the scene that fills the picture at that distance.
double VisibleExtent(const View& view, vtkCamera* camera)
{
  const glm::dvec2 size(view.Viewport.z, view.Viewport.w);
  const double aspect = std::max(size.x / std::max(size.y, 1.0), 1.0);
  const double height = view.Parallel
    ? camera->GetParallelScale()
    : FocusDistance(view, camera) * std::tan(0.5 * glm::radians(camera->GetViewAngle()));
  return 2.0 * height * aspect;
}

glm::dvec3 FocusPoint(const View& view, vtkCamera* camera)
{
  const glm::dvec3 low(view.Bounds[0], view.Bounds[2], view.Bounds[4]);
  const glm::dvec3 high(view.Bounds[1], view.Bounds[3], view.Bounds[5]);
  const glm::dvec3 ahead = -glm::dvec3(view.ViewToWorld[2]);
  return glm::clamp(
    glm::dvec3(view.ViewToWorld[3]) + FocusDistance(view, camera) * ahead, low, high);
}
}

int LiveField::Settings::ProbesPerFrame(int probes, int slices) const
{
  const int affordable = this->RaysBudget > 0 ? this->RaysBudget / this->Rays : probes;
  return std::max(1, std::min(affordable, (probes + slices - 1) / slices));
}

void LiveField::BeginFrame(const View& view, const Settings& settings, vtkMTimeType parameters)
{
  const std::array<int, 2> requestedLayout = { settings.Probes, settings.Grids };
  if (view.StandsAlone || requestedLayout != this->RequestedLayout ||
    !this->Grids().Get(0).Suits(view.Bounds))
  {
    *this = LiveField();
    this->Current = settings;
    this->RequestedLayout = requestedLayout;
    this->CreateGrids(view);
  }
  this->Current = settings;
  if (view.StandsAlone)
  {
    this->Current.RaysBudget = 0; // all updates are done in this frame anyway
    this->Current.Slices = 1;
  }
  const SceneChanges& changes = view.Changes;
  const bool other =
    changes.Lights || changes.Props || changes.Appearance || this->Parameters != parameters;
  if (other || changes.CarriedLights)
  {
    this->UpdatesSinceSceneChange = this->UpdatesSinceChange = 0;
  }
  if (other)
  {
    this->UpdatesSinceOtherChange = 0;
  }
  if (changes.Props)
  {
    this->DistanceUpdates = std::min(this->DistanceUpdates, InitialDistanceUpdates);
    this->DistanceUpdatesSinceMove =
      std::min(this->DistanceUpdatesSinceMove, InitialDistanceUpdates);
    this->GeometryMoved = true;
    this->UnconnectedProbes = this->Grids().Size();
  }
  this->Parameters = parameters;
}

void LiveField::CreateGrids(const View& view)
{
  const int probes = this->Current.Probes / this->Current.Grids;
  this->Nested = NestedGrids(ProbeGrid::Around(view.Bounds, probes), this->Current.Grids, probes);
  this->Update.Uniforms.Grids = this->Nested.List();
}

void LiveField::Follow(Frame& frame)
{
  NestedGrids& grids = this->Nested;
  const View& view = frame.GetView();
  vtkCamera* camera = frame.GetRenderer()->GetActiveCamera();
  const bool fixed = this->Current.Refinement > 0.0;
  const bool rescaled =
    grids.SetRefinement(fixed ? std::max(this->Current.Refinement, NestedGrids::LeastRefinement)
                              : grids.RefinementFor(VisibleExtent(view, camera)));
  const glm::dvec3 focus = FocusPoint(view, camera);
  for (int number = 1; number < grids.Count(); ++number)
  {
    const ProbeGrid grid = grids.Get(number);
    const glm::ivec3 moved = grids.Follow(number, focus, this->Uninitialized || rescaled);
    this->Update.Uniforms.Grids = grids.List();
    if (!this->Uninitialized && (rescaled || moved != glm::ivec3(0)))
    {
      this->Update.Scroll(frame, this->ProbeMaps, number, rescaled ? grid.Counts : moved);
      this->UpdatesSinceChange = 0;
      this->UpdatesSinceSceneChange = std::min(this->UpdatesSinceSceneChange, UpdatesOnTheMove);
      this->DistanceUpdatesSinceMove =
        std::min(this->DistanceUpdatesSinceMove, InitialDistanceUpdates);
      this->UnconnectedProbes = this->Grids().Size();
    }
  }
}

void LiveField::AddUpdates(Frame& frame, RayProps& rays, LightTable& lights, bool skyApart)
{
  const int size = this->Grids().Size();
  this->ProbeMaps = LiveProbeMaps::Keep(frame, size, this->Current.Rays);
  this->Uninitialized |= this->ProbeMaps.AreEmpty() || skyApart != this->Update.SkyApart;
  this->Update.SkyApart = skyApart;
  this->Update.SeeksEmitters = rays.SeeksEmitters(frame.GetView().Diagonal);
  // When emitters disappear, their light fades from both maps.
  this->Update.KeepsEmitted =
    rays.HasEmitters() || (this->Update.KeepsEmitted && !this->Uninitialized);
  if (!this->ProbeMaps.RayResults->Written)
  {
    this->CompleteRayResults = this->NextProbe == 0 ? 0 : -1;
  }
  if (this->Uninitialized)
  {
    this->ProbeMaps.Clear(frame);
    this->NextProbe = this->TotalUpdates = 0;
    this->UpdatesSinceSceneChange = this->UpdatesSinceChange = 0;
    this->UpdatesSinceOtherChange = 0;
    this->DistanceUpdates = this->DistanceUpdatesSinceMove = 0;
    this->UnconnectedProbes = size;
  }
  // Light has to arrive within a frame that stands alone.
  const int updates =
    frame.GetView().StandsAlone ? std::min(this->Current.Updates, LoneUpdates) : 1;
  do
  {
    this->AddUpdate(frame, rays, lights);
  } while (this->UpdatesSinceChange < updates && frame.GetView().StandsAlone);
}

void LiveField::AddUpdate(Frame& frame, RayProps& rays, LightTable& lights)
{
  const int size = this->Grids().Size();
  LiveProbeUpdate& update = this->Update;
  update.Uniforms.Origin = rays.Origin();
  update.Uniforms.Bias = this->Current.Bias;
  update.Rays = &rays;
  update.Lights = &lights;
  update.RayCount = this->Current.Rays;
  update.UpdateNumber = this->TotalUpdates;
  update.First = this->NextProbe;
  this->Follow(frame);
  this->Uninitialized = false;
  const bool sliced = this->UpdatesSinceOtherChange >= AdaptationUpdates &&
    this->UpdatesSinceChange < this->UpdatesSinceOtherChange;
  const int affordable = this->Current.ProbesPerFrame(size, sliced ? this->Current.Slices : 1);
  update.Last = std::min(this->NextProbe + affordable, size);
  if (this->UpdatesSinceChange >= this->Current.Updates)
  {
    return; // the probes rest
  }
  const bool relocates = this->NextProbe == 0 && this->CompleteRayResults > 0 &&
    this->TotalUpdates % RelocationInterval == FirstRelocation &&
    this->UpdatesSinceChange < LastRelocation && this->Current.Relocate;
  if (relocates)
  {
    update.Relocate(frame, this->ProbeMaps, this->GeometryMoved);
    this->GeometryMoved = false;
    update.Connect(frame, this->ProbeMaps, 0, size);
    this->UnconnectedProbes = 0;
  }
  if (this->UnconnectedProbes > 0)
  {
    update.Connect(frame, this->ProbeMaps, update.First, update.Last);
    this->UnconnectedProbes -= update.Last - update.First;
  }
  // The first update ever only finds distances, and what lights and emitters send straight.
  const bool adapts = this->TotalUpdates > 0 && this->UpdatesSinceSceneChange < AdaptationUpdates;
  update.Parts = adapts ? LiveProbeUpdate::MaximumParts(this->Current.Rays) : 1;
  const double share = BlendShare(this->UpdatesSinceSceneChange, this->Current.Hysteresis);
  for (update.Part = 0; update.Part < update.Parts; ++update.Part)
  {
    update.Trace(frame, this->ProbeMaps);
    update.BlendLight(frame, this->ProbeMaps, share);
  }
  this->BlendDistances(frame);
  this->Advance();
}

void LiveField::BlendDistances(Frame& frame)
{
  // After the first updates only some probes at a time, because blending distances is expensive.
  const bool all = this->DistanceUpdates < InitialDistanceUpdates;
  const int previousUpdates = all
    ? this->DistanceUpdates
    : InitialDistanceUpdates + (this->DistanceUpdates - InitialDistanceUpdates) / DistanceStride;
  const int stride =
    all ? 1 : (this->DistanceUpdatesSinceMove < MaximumDistanceUpdates ? DistanceStride : 0);
  this->Update.BlendDistances(frame, this->ProbeMaps, previousUpdates, stride);
}

// Continue with the probes after those of this frame. The last probe completes the update.
void LiveField::Advance()
{
  this->NextProbe = this->Update.Last;
  if (this->NextProbe >= this->Grids().Size())
  {
    this->NextProbe = 0;
    ++this->TotalUpdates;
    ++this->CompleteRayResults;
    ++this->UpdatesSinceSceneChange;
    ++this->UpdatesSinceOtherChange;
    ++this->UpdatesSinceChange;
    ++this->DistanceUpdates;
    ++this->DistanceUpdatesSinceMove;
  }
}
}
