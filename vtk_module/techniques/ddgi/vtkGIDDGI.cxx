// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIDDGI.h"

#include "probes/ProbeBalls.h"
#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"
#include "techniques/ddgi/LiveField.h"

vtkStandardNewMacro(vtkGIDDGI);

using namespace penumbra;

namespace
{
// What the passes hand on, beside the textures that they keep.
constexpr const char* Traced = "ddgi.traced";
constexpr const char* Blended = "ddgi.blended";

LiveField::Settings SettingsOf(vtkGIDDGI& technique)
{
  LiveField::Settings settings;
  settings.Probes = technique.GetProbes();
  settings.Grids = technique.GetGrids();
  settings.Refinement = technique.GetRefinement();
  settings.Rays = technique.GetRays();
  settings.RaysBudget = technique.GetRaysPerFrame();
  settings.Updates = technique.GetUpdates();
  settings.Hysteresis = technique.GetHysteresis();
  settings.Bias = technique.GetBias();
  settings.Relocate = technique.GetRelocate();
  return settings;
}

void Gather(FrameContext& context, const LiveField& field, double intensity)
{
  const OpenDirection open(context);
  Defines variant = open.Variant;
  variant.merge(field.Uniforms().Variant());
  const Program& program = context.Shaders().Fragment("ddgi/gather.frag", variant);
  const LiveProbeMaps& maps = field.Maps();
  context.Use(program,
    { context.Input(resource::WindowDepth), context.Input(resource::Albedo),
      context.Input(resource::Normal), open.Map, maps.Light, maps.Distance, maps.Probes });
  field.Uniforms().Set(program);
  SetProbeView(program, context.GetView(), field.Uniforms().Origin);
  glUniform1f(program.Location("intensity"), static_cast<GLfloat>(intensity));
  context.DrawFullscreen();
}

// For translucent surfaces and volumes.
void BindForward(ForwardProgram& program, const LiveField& field)
{
  field.Uniforms().Set(program);
  program.SetTexture("fieldLight", field.Maps().Light->Get());
  program.SetTexture("fieldDistance", field.Maps().Distance->Get());
  program.SetTexture("fieldProbes", field.Maps().Probes->Get());
}

ForwardPart ForwardOf(const LiveField& field, std::function<void(ForwardProgram&)> bind)
{
  ForwardPart part;
  part.Source = "ddgi/forward.glsl";
  part.OnSurfaces = part.InVolumes = field.Uniforms().Variant();
  part.Textures = 3;
  part.Bind = std::move(bind);
  return part;
}

ProbeBalls Balls(const LiveField& field)
{
  const LiveProbeMaps& maps = field.Maps();
  return { "ddgi/show.frag", maps.Light, maps.Distance, maps.Probes, field.Uniforms().Origin,
    [&field](const Program& program) {
      field.Uniforms().Set(program);
      field.Maps().BindStates();
    } };
}
}

vtkGIDDGI::vtkGIDDGI() = default;
vtkGIDDGI::~vtkGIDDGI() = default;

void vtkGIDDGI::Plan(LightingPlan& plan, FrameBuilder& frame)
{
  const View& view = frame.GetView();
  if (view.Diagonal > 0.0)
  {
    LiveField& field = frame.ViewState<LiveField>(this);
    field.Prepare(view, SettingsOf(*this), this->GetMTime());
    plan.KnowIndirectLight(IndirectKind::LiveProbes, field.Grids().Detail());
  }
}

void vtkGIDDGI::Contribute(FrameBuilder& frame)
{
  const View& view = frame.GetView();
  if (view.Diagonal <= 0.0)
  {
    return;
  }
  RayProps& rays = frame.Rays();
  if (rays.LeftOut() > 0)
  {
    frame.AddNote("rays do not see " + std::to_string(rays.LeftOut()) +
      " props of kinds that cannot be traced yet: they send no indirect light");
  }
  LiveField& field = frame.ViewState<LiveField>(this);
  LightTable& lights = frame.Lights();
  const TextureDesc token = { GL_R8, 1, 1, 0 };
  frame.AddPass("ddgi-trace")
    .Write(Traced, token)
    .Execute(
      [&field, &rays, &lights](FrameContext& context) { field.Trace(context, rays, lights); });
  frame.AddPass("ddgi-blend")
    .Read(Traced)
    .Write(Blended, token)
    .Execute([&field](FrameContext& context) { field.Blend(context); });
  frame.AddIndirectLight({ IndirectKind::LiveProbes,
    { Blended, resource::Albedo, resource::Normal, resource::WindowDepth },
    [this, &field](FrameContext& context) { Gather(context, field, this->Intensity); },
    ForwardOf(field, [this, &field, toWorld = view.ViewToWorld](ForwardProgram& program) {
      BindForward(program, field);
      program.SetField(toWorld, field.Uniforms().Origin, this->Intensity);
    }) });
  if (this->Show)
  {
    AddProbeBalls(
      frame, "ddgi-balls", { Blended }, [&field](FrameContext&) { return Balls(field); });
  }
}

bool vtkGIDDGI::StandsIn(const LightingPlan& plan)
{
  return plan.NeedsLiveLight();
}

const LiveField* vtkGIDDGI::Find(vtkRenderer* renderer) const
{
  const ViewState* view = this->Views ? this->Views->FindView(renderer) : nullptr;
  return view ? view->Find<LiveField>(this) : nullptr;
}

int vtkGIDDGI::GetRequiredFrames()
{
  const int probes = SettingsOf(*this).ProbesPerFrame(this->Probes);
  return this->Updates * ((this->Probes + probes - 1) / probes);
}

bool vtkGIDDGI::IsFinished(vtkRenderer* renderer)
{
  return this->GetUpdatesDone(renderer) >= this->Updates;
}

int vtkGIDDGI::GetUpdatesDone(vtkRenderer* renderer)
{
  const LiveField* field = this->Find(renderer);
  return field ? field->UpdatesDone() : 0;
}

void vtkGIDDGI::GetGrid(vtkRenderer* renderer, int counts[3])
{
  const LiveField* field = this->Find(renderer);
  const glm::ivec3 grid = field ? field->Grids().Get(0).Counts : glm::ivec3(0);
  std::copy_n(&grid[0], 3, counts);
}

void vtkGIDDGI::GetGridBounds(vtkRenderer* renderer, int number, double bounds[6])
{
  const LiveField* field = this->Find(renderer);
  const bool known = field && number >= 0 && number < field->Grids().Count();
  const ProbeGrid grid = known ? field->Grids().Get(number) : ProbeGrid();
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = known ? grid.First[axis] : 1.0;
    bounds[2 * axis + 1] = known ? grid.Last()[axis] : -1.0;
  }
}
