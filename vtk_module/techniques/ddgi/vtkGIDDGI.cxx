// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIDDGI.h"

#include "probes/ProbeBalls.h"
#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"
#include "techniques/ddgi/LiveField.h"

#include "vtkCamera.h"
#include "vtkWeakPointer.h"

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

struct vtkGIDDGI::State
{
  struct Owned
  {
    vtkWeakPointer<vtkRenderer> Owner;
    LiveField Field;
  };

  std::map<std::pair<vtkRenderer*, int>, Owned> Fields; ///< by renderer and eye

  // Another renderer may come to a dead one's address.
  void ForgetTheDead()
  {
    for (auto it = this->Fields.begin(); it != this->Fields.end();)
    {
      it = it->second.Owner ? std::next(it) : this->Fields.erase(it);
    }
  }

  LiveField& Of(vtkRenderer* renderer)
  {
    Owned& owned = this->Fields[{ renderer, renderer->GetActiveCamera()->GetLeftEye() }];
    owned.Owner = renderer;
    return owned.Field;
  }

  // Of the first eye.
  const LiveField* Find(vtkRenderer* renderer) const
  {
    const auto found = this->Fields.lower_bound({ renderer, 0 });
    const bool known = found != this->Fields.end() && found->first.first == renderer;
    return known ? &found->second.Field : nullptr;
  }
};

vtkGIDDGI::vtkGIDDGI()
  : Impl(new State)
{
}

vtkGIDDGI::~vtkGIDDGI() = default;

void vtkGIDDGI::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Fields.clear();
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
  this->Impl->ForgetTheDead();
  LiveField& field = this->Impl->Of(frame.GetRenderer());
  field.Prepare(view, SettingsOf(*this), this->GetMTime());
  LightTable& lights = frame.Lights();
  const TextureDesc token = { GL_R8, 1, 1, 0 };
  // Fields stay where they are in memory as long as their renderers live.
  frame.AddPass("ddgi-trace")
    .Write(Traced, token)
    .Execute(
      [&field, &rays, &lights](FrameContext& context) { field.Trace(context, rays, lights); });
  frame.AddPass("ddgi-blend")
    .Read(Traced)
    .Write(Blended, token)
    .Execute([&field](FrameContext& context) { field.Blend(context); });
  frame.AddIndirectLight({ IndirectKind::LiveProbes, field.Grids().Detail(),
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

bool vtkGIDDGI::StandsIn(const FrameBuilder& frame)
{
  return frame.NeedsLiveLight();
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
  const LiveField* field = this->Impl->Find(renderer);
  return field ? field->UpdatesDone() : 0;
}

void vtkGIDDGI::GetGrid(vtkRenderer* renderer, int counts[3])
{
  const LiveField* field = this->Impl->Find(renderer);
  const glm::ivec3 grid = field ? field->Grids().Get(0).Counts : glm::ivec3(0);
  std::copy_n(&grid[0], 3, counts);
}

void vtkGIDDGI::GetGridBounds(vtkRenderer* renderer, int number, double bounds[6])
{
  const LiveField* field = this->Impl->Find(renderer);
  const bool known = field && number >= 0 && number < field->Grids().Count();
  const ProbeGrid grid = known ? field->Grids().Get(number) : ProbeGrid();
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = known ? grid.First[axis] : 1.0;
    bounds[2 * axis + 1] = known ? grid.Last()[axis] : -1.0;
  }
}
