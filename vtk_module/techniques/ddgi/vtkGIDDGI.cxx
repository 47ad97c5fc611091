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
LiveField::Settings SettingsOf(vtkGIDDGI& technique)
{
  LiveField::Settings settings;
  settings.Probes = technique.GetProbes();
  settings.Grids = technique.GetGrids();
  settings.Refinement = technique.GetRefinement();
  settings.Rays = technique.GetRays();
  settings.RaysBudget = technique.GetRaysPerFrame();
  settings.Slices = technique.GetSlices();
  settings.Updates = technique.GetUpdates();
  settings.Hysteresis = technique.GetHysteresis();
  settings.Bias = technique.GetBias();
  settings.Relocate = technique.GetRelocate();
  return settings;
}

// Sets the probes' inputs for translucent surfaces and volumes.
void BindForward(ForwardProgram& program, const LiveField& field)
{
  program.Set(field.Uniforms().ShaderArguments());
  program.SetTexture("fieldLight", field.Maps().Light->Storage.Get());
  program.SetTexture("fieldDistance", field.Maps().Distance->Storage.Get());
  program.SetTexture("fieldProbes", field.Maps().Probes->Storage.Get());
}

ForwardPart MakeForwardPart(const LiveField& field, std::function<void(ForwardProgram&)> bind)
{
  ForwardPart part;
  part.Source = "ddgi/forward.glsl";
  part.OnSurfaces = part.InVolumes = field.Uniforms().Variant();
  part.Textures = 3;
  part.Bind = std::move(bind);
  return part;
}

// Declares what a pass reads whose shader looks up the probes' light at the surfaces of the picture.
void ReadField(PassDeclaration& pass, const LiveField& field, const View& view)
{
  field.Maps().ReadField(pass);
  pass.Offer(field.Uniforms().ShaderArguments()).Offer(view.ToScene(field.Uniforms().Origin));
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
    field.BeginFrame(view, SettingsOf(*this), this->GetMTime());
    plan.AnnounceIndirectLight(IndirectKind::LiveProbes, field.Grids().Detail());
  }
}

void vtkGIDDGI::Contribute(FrameBuilder& frame)
{
  const View& view = frame.GetView();
  if (view.Diagonal <= 0.0)
  {
    return;
  }
  RayProps& rays = frame.Rays("they send no indirect light");
  LiveField& field = frame.ViewState<LiveField>(this);
  LightTable& lights = frame.Lights();
  field.AddUpdates(frame, rays, lights, frame.Plan().LightsSky());
  IndirectLight light;
  light.Kind = IndirectKind::LiveProbes;
  light.Declare = [this, &field, &view](PassDeclaration& pass) {
    pass.Read(resource::DepthCopy)
      .Read(resource::Albedo)
      .Read(resource::Normal)
      .Offer(this->GetShaderParameters());
    ReadField(pass, field, view);
  };
  light.Draw = [&field](FrameContext& context) {
    Arguments arguments;
    Defines variant = OpenDirection(context, arguments);
    variant.merge(field.Uniforms().Variant());
    context.DrawBound("ddgi/gather.frag", variant, arguments);
  };
  light.Forward =
    MakeForwardPart(field, [this, &field, toWorld = view.ViewToWorld](ForwardProgram& program) {
      BindForward(program, field);
      program.SetField(toWorld, field.Uniforms().Origin, this->Intensity);
    });
  light.Field.Variant = field.Uniforms().Variant();
  light.Field.Variant["GI_LIVE_FIELD"] = "1";
  light.Field.Declare = [&field](PassDeclaration& pass) {
    field.Maps().ReadField(pass);
    pass.Offer(field.Uniforms().ShaderArguments());
  };
  frame.AddIndirectLight(std::move(light));
  if (this->Show)
  {
    AddProbeBalls(frame, "ddgi-balls", "ddgi/show.frag", [&](PassDeclaration& pass) {
      ReadField(pass, field, view);
      pass.UpdateHistory(*field.Maps().States, "states");
    });
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
  const int probes = SettingsOf(*this).ProbesPerFrame(this->Probes, 1);
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
  const bool exists = field && number >= 0 && number < field->Grids().Count();
  const ProbeGrid grid = exists ? field->Grids().Get(number) : ProbeGrid();
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = exists ? grid.First[axis] : 1.0;
    bounds[2 * axis + 1] = exists ? grid.Last()[axis] : -1.0;
  }
}
