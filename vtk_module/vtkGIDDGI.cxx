// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIDDGI.h"

#include "private/Frame.h"
#include "private/ProbeBalls.h"
#include "private/ProbeGrid.h"
#include "private/rays/RayProps.h"

#include "vtkCamera.h"
#include "vtkWeakPointer.h"

#include <glm/gtc/constants.hpp>

vtkStandardNewMacro(vtkGIDDGI);

using namespace penumbra;

namespace
{
// Distances are kept as they are after so many updates of geometry that stands still.
constexpr int AllDistances = 8;
constexpr int DistanceStride = 4;
constexpr int MostDistances = AllDistances + 64 * DistanceStride;

// As in glsl/ddgi/field.glsl.
constexpr int LightTexels = 8;
constexpr int DistanceTexels = 16;
constexpr int Columns = 64;

// What the passes hand on, beside the textures that they keep.
constexpr const char* Traced = "ddgi.traced";
constexpr const char* Blended = "ddgi.blended";

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
}

namespace
{
struct Textures
{
  Texture* Directions = nullptr;
  Texture* Found = nullptr;
  Texture* Light = nullptr;
  Texture* Distance = nullptr;
  Texture* Probes = nullptr;
  Texture* Places = nullptr; ///< to come into Probes
  Texture* States = nullptr;
};

// Along a spiral, neighbours in the table being neighbours on the sphere (Bauer 2000, Distribution of Points on
// a Sphere with Application to Star Catalogs).
std::vector<glm::vec4> EvenDirections(int count)
{
  std::vector<glm::vec4> directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double turn = std::sqrt(glm::pi<double>() * count) * std::acos(z);
    const double radius = std::sqrt(1.0 - z * z);
    directions.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z, 0.0);
  }
  return directions;
}

void Fill(const Texture& texture, const std::vector<glm::vec4>& texels)
{
  glBindTexture(GL_TEXTURE_2D, texture.Get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.Desc().Width, texture.Desc().Height, GL_RGBA,
    GL_FLOAT, texels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

// fresh: their contents are not yet defined.
Textures FieldTextures(FrameContext& context, int probes, int rays, bool& fresh)
{
  const int columns = std::min(probes, Columns);
  const int rows = (probes + Columns - 1) / Columns;
  bool made = false;
  fresh = false;
  const auto get = [&](const char* name, GLenum format, int width, int height) {
    Texture& texture = context.History(name, { format, width, height, 0 }, made);
    fresh |= made;
    return &texture;
  };
  Textures textures;
  textures.Found = &context.History("ddgi.rays", { GL_RGBA32F, rays, probes, 0 }, made);
  textures.Directions = &context.History("ddgi.directions", { GL_RGBA32F, rays, 1, 0 }, made);
  if (made)
  {
    Fill(*textures.Directions, EvenDirections(rays));
  }
  textures.Light =
    get("ddgi.light", GL_RGBA32F, columns * (LightTexels + 2), rows * (LightTexels + 2));
  textures.Distance =
    get("ddgi.distance", GL_RG32F, columns * (DistanceTexels + 2), rows * (DistanceTexels + 2));
  textures.Probes = get("ddgi.probes", GL_RGBA32F, columns, rows);
  textures.Places = get("ddgi.places", GL_RGBA32F, columns, rows);
  textures.States = get("ddgi.states", GL_RGBA32F, columns, rows);
  if (fresh)
  {
    for (Texture* texture : { textures.Light, textures.Distance })
    {
      texture->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
      texture->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
    const auto fill = [columns, rows](const Texture& texture, const glm::vec4& value) {
      Fill(texture, std::vector<glm::vec4>(static_cast<std::size_t>(columns) * rows, value));
    };
    fill(*textures.Probes, glm::vec4(0.0f));
    fill(*textures.Places, glm::vec4(0.0f));
    fill(*textures.States, glm::vec4(0.0f, 0.0f, 1.0f, 0.0f));
  }
  return textures;
}

/// What every shader that asks the probes needs.
struct FieldUniforms
{
  ProbeGrid Grid;
  glm::dvec3 Origin{ 0.0 };
  double Bias = 0.0;

  void Set(const Program& program) const
  {
    const glm::vec3 first(this->Grid.First - this->Origin);
    const glm::vec3 spacing(this->Grid.Spacing);
    glUniform3fv(program.Location("fieldOrigin"), 1, &first[0]);
    glUniform3fv(program.Location("fieldSpacing"), 1, &spacing[0]);
    glUniform3iv(program.Location("fieldCounts"), 1, &this->Grid.Counts[0]);
    glUniform1i(program.Location("fieldColumns"), std::min(this->Grid.Size(), Columns));
    glUniform1f(program.Location("fieldBias"), static_cast<GLfloat>(this->Bias));
  }
};

struct FieldUpdate
{
  FieldUniforms Uniforms;
  RayProps* Rays = nullptr;
  LightTable* Lights = nullptr;
  int RayCount = 0;
  int Number = 0; ///< of the update, for the rays' directions
  int First = 0;  ///< of its probes, those that this frame updates
  int Last = 0;   ///< one past them

  void Trace(FrameContext& context, const Textures& textures) const
  {
    const Program& program =
      context.Shaders().Compute("ddgi/trace.comp", this->Rays->ShaderDefines());
    context.Use(program,
      { nullptr, nullptr, nullptr, textures.Directions, textures.Light, textures.Distance,
        textures.Probes });
    this->Rays->Bind(program);
    this->Lights->BindWorld(0, this->Rays->Origin());
    this->Uniforms.Set(program);
    glBindImageTexture(0, textures.Found->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    BindStates(textures);
    const glm::vec3 eye(glm::dvec3(context.GetView().ViewToWorld[3]) - this->Rays->Origin());
    glUniform3fv(program.Location("eye"), 1, &eye[0]);
    glUniform1i(program.Location("rays"), this->RayCount);
    glUniform1i(program.Location("update"), this->Number);
    glUniform1i(program.Location("firstProbe"), this->First);
    glUniform1i(program.Location("lastProbe"), this->Last);
    glUniform1i(program.Location("lightCount"), static_cast<GLint>(this->Lights->Lights().size()));
    glUniform1i(program.Location("lit"), this->Number > 0);
    constexpr int group = 64;
    const int rays = this->RayCount * (this->Last - this->First);
    glDispatchCompute((rays + group - 1) / group, 1, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  }

  static void BindStates(const Textures& textures)
  {
    glBindImageTexture(2, textures.States->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  }

  // Where each should stand goes to Places.
  void Relocate(FrameContext& context, const Textures& textures, bool geometryMoves) const
  {
    const Program& program =
      context.Shaders().Compute("ddgi/relocate.comp", this->Rays->ShaderDefines());
    context.Use(program,
      { textures.Found, nullptr, nullptr, textures.Directions, textures.Light, textures.Distance,
        textures.Probes });
    this->Rays->Bind(program);
    this->Uniforms.Set(program);
    glBindImageTexture(0, textures.Places->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(1, textures.Light->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    BindStates(textures);
    glUniform1i(program.Location("probeCount"), this->Uniforms.Grid.Size());
    glUniform1i(program.Location("rays"), this->RayCount);
    glUniform1i(program.Location("update"), this->Number - 1);
    glUniform1i(program.Location("geometryMoves"), geometryMoves);
    constexpr int group = 64;
    glDispatchCompute((this->Uniforms.Grid.Size() + group - 1) / group, 1, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  }

  // Probes from one to another, that one not counted, go to their Places and learn whom they see from there.
  void Connect(FrameContext& context, const Textures& textures, int first, int last) const
  {
    const Program& program =
      context.Shaders().Compute("ddgi/connect.comp", this->Rays->ShaderDefines());
    context.Use(program, { nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, textures.Places });
    this->Rays->Bind(program);
    this->Uniforms.Set(program);
    glBindImageTexture(0, textures.Probes->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glUniform1i(program.Location("firstProbe"), first);
    glUniform1i(program.Location("lastProbe"), last);
    constexpr int group = 64;
    glDispatchCompute((last - first + group - 1) / group, 1, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  }

  // stride: see blend.comp; of distances only.
  void Blend(FrameContext& context, const Textures& textures, bool distances, double least,
    int most, int stride) const
  {
    Defines defines;
    if (distances)
    {
      defines["GI_BLEND_DISTANCE"] = "1";
    }
    const Program& program = context.Shaders().Compute("ddgi/blend.comp", defines);
    context.Use(program, { textures.Found, nullptr, nullptr, textures.Directions });
    this->Uniforms.Set(program);
    const Texture* map = distances ? textures.Distance : textures.Light;
    glBindImageTexture(1, map->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, map->Desc().Format);
    glUniform1i(program.Location("rays"), this->RayCount);
    glUniform1i(program.Location("update"), this->Number);
    BindStates(textures);
    glUniform1f(program.Location("least"), static_cast<GLfloat>(least));
    glUniform1f(program.Location("most"), static_cast<GLfloat>(most));
    glUniform1f(program.Location("farthest"),
      static_cast<GLfloat>(1.5 * glm::length(this->Uniforms.Grid.Spacing)));
    glUniform1i(program.Location("firstProbe"), this->First);
    glUniform1i(program.Location("stride"), stride);
    glDispatchCompute(this->Last - this->First, 1, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  }
};

void Gather(
  FrameContext& context, const Textures& textures, const FieldUniforms& uniforms, double intensity)
{
  const OpenDirection open(context);
  const Program& program = context.Shaders().Fragment("ddgi/gather.frag", open.Variant);
  context.Use(program,
    { context.Input(resource::WindowDepth), context.Input(resource::Albedo),
      context.Input(resource::Normal), open.Map, textures.Light, textures.Distance,
      textures.Probes });
  uniforms.Set(program);
  SetProbeView(program, context.GetView(), uniforms.Origin);
  glUniform1f(program.Location("intensity"), static_cast<GLfloat>(intensity));
  context.DrawFullscreen();
}

// For translucent surfaces and volumes.
void BindForward(ForwardProgram& program, const Textures& textures, const FieldUniforms& uniforms)
{
  uniforms.Set(program);
  program.SetTexture("fieldLight", textures.Light->Get());
  program.SetTexture("fieldDistance", textures.Distance->Get());
  program.SetTexture("fieldProbes", textures.Probes->Get());
}

ForwardPart ForwardOf(std::function<void(ForwardProgram&)> bind)
{
  ForwardPart part;
  part.Source = "ddgi/forward.glsl";
  part.Textures = 3;
  part.Bind = std::move(bind);
  return part;
}

ProbeBalls Balls(const Textures& textures, const FieldUniforms& uniforms)
{
  return { "ddgi/show.frag", textures.Light, textures.Distance, textures.Probes, uniforms.Origin,
    uniforms.Grid.Spacing, [textures, uniforms](const Program& program) {
      uniforms.Set(program);
      FieldUpdate::BindStates(textures);
    } };
}
}

/// The probes of one view.
struct vtkGIDDGI::Field
{
  vtkWeakPointer<vtkRenderer> Owner;
  ProbeGrid Grid;
  int Next = 0;        ///< probe to be updated
  int Unconnected = 0; ///< of them, from Next on: sight of each other may have changed
  int Updates = 0;     ///< since the scene changed
  int Total = 0;       ///< since the grid was made
  int Seen = 0;        ///< updates of the distances since geometry changed, likewise
  bool Moved = false;  ///< geometry, since it was judged where probes should stand
  int Asked = 0;       ///< probes that Grid was made for
  vtkMTimeType Parameters = 0;
  Textures Maps;
  FieldUpdate Update;

  // After a frame's probes, to the next; after the last, the update is done.
  void Advance()
  {
    this->Next = this->Update.Last;
    if (this->Next >= this->Grid.Size())
    {
      this->Next = 0;
      ++this->Seen;
      ++this->Updates;
      ++this->Total;
    }
  }
};

struct vtkGIDDGI::State
{
  std::map<std::pair<vtkRenderer*, int>, Field> Fields; ///< by renderer and eye

  // Another renderer may come to a dead one's address.
  void ForgetTheDead()
  {
    for (auto it = this->Fields.begin(); it != this->Fields.end();)
    {
      it = it->second.Owner ? std::next(it) : this->Fields.erase(it);
    }
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
  const std::pair<vtkRenderer*, int> key(
    frame.GetRenderer(), frame.GetRenderer()->GetActiveCamera()->GetLeftEye());
  this->Impl->ForgetTheDead();
  Field& field = this->Impl->Fields[key];
  if (field.Asked != this->Probes || !field.Grid.Suits(view.Bounds))
  {
    field = Field();
    field.Owner = frame.GetRenderer();
    field.Grid = ProbeGrid::Around(view.Bounds, this->Probes);
    field.Asked = this->Probes;
    field.Unconnected = field.Grid.Size();
  }
  const bool changed = view.Changes.Lights || view.Changes.Props || view.Changes.Looks ||
    field.Parameters != this->GetMTime();
  field.Parameters = this->GetMTime();
  if (changed)
  {
    field.Updates = 0;
    field.Seen = view.Changes.Props ? std::min(field.Seen, AllDistances) : field.Seen;
    field.Moved |= view.Changes.Props;
    field.Unconnected = view.Changes.Props ? field.Grid.Size() : field.Unconnected;
  }
  LightTable& lights = frame.Lights();
  const TextureDesc token = { GL_R8, 1, 1, 0 };
  frame.AddPass("ddgi-trace")
    .Write(Traced, token)
    .Execute([this, key, &rays, &lights](FrameContext& context) {
      Field& now = this->Impl->Fields[key];
      bool fresh = false;
      now.Maps = FieldTextures(context, now.Grid.Size(), this->Rays, fresh);
      if (fresh)
      {
        now.Next = now.Updates = now.Total = now.Seen = 0;
        now.Unconnected = now.Grid.Size();
      }
      now.Update = { { now.Grid, rays.Origin(), this->Bias }, &rays, &lights, this->Rays, now.Total,
        now.Next, now.Next + this->ProbesPerFrame(now.Grid.Size() - now.Next) };
      if (now.Updates < this->Updates)
      {
        const bool judged = now.Next == 0 && now.Total % Judgement == FirstJudgement &&
          now.Updates < Agile && this->Relocate;
        if (judged)
        {
          now.Update.Relocate(context, now.Maps, now.Moved);
          now.Moved = false;
          now.Update.Connect(context, now.Maps, 0, now.Grid.Size());
          now.Unconnected = 0;
        }
        if (now.Unconnected > 0)
        {
          now.Update.Connect(context, now.Maps, now.Update.First, now.Update.Last);
          now.Unconnected -= now.Update.Last - now.Update.First;
        }
        now.Update.Trace(context, now.Maps);
      }
    });
  frame.AddPass("ddgi-blend")
    .Read(Traced)
    .Write(Blended, token)
    .Execute([this, key](FrameContext& context) {
      Field& now = this->Impl->Fields[key];
      if (now.Updates < this->Updates)
      {
        // After the first updates, a few of the probes at a time: distances take long to blend.
        const bool all = now.Seen < AllDistances;
        const int stride = all ? 1 : DistanceStride;
        const int seen = all ? now.Seen : AllDistances + (now.Seen - AllDistances) / stride;
        now.Update.Blend(context, now.Maps, true, 0.0, seen, now.Seen < MostDistances ? stride : 0);
        now.Update.Blend(context, now.Maps, false, ShareOf(now.Updates, this->Hysteresis),
          std::numeric_limits<int>::max(), 0);
        now.Advance();
      }
    });
  frame.AddIndirectLight({ IndirectKind::LiveProbes, field.Grid.Detail(),
    { Blended, resource::Albedo, resource::Normal, resource::WindowDepth },
    [this, key](FrameContext& context) {
      const Field& now = this->Impl->Fields[key];
      Gather(context, now.Maps, now.Update.Uniforms, this->Intensity);
    },
    ForwardOf([this, key, toWorld = view.ViewToWorld](ForwardProgram& program) {
      const Field& now = this->Impl->Fields[key];
      BindForward(program, now.Maps, now.Update.Uniforms);
      program.SetField(toWorld, now.Update.Uniforms.Origin, this->Intensity);
    }) });
  if (this->Show)
  {
    AddProbeBalls(frame, "ddgi-balls", { Blended }, [this, key](FrameContext&) {
      const Field& now = this->Impl->Fields[key];
      return Balls(now.Maps, now.Update.Uniforms);
    });
  }
}

int vtkGIDDGI::ProbesPerFrame(int most) const
{
  const int afforded = this->RaysPerFrame > 0 ? this->RaysPerFrame / this->Rays : most;
  return std::max(1, std::min(afforded, most));
}

int vtkGIDDGI::GetRequiredFrames()
{
  const int probes = this->ProbesPerFrame(this->Probes);
  return this->Updates * ((this->Probes + probes - 1) / probes);
}

bool vtkGIDDGI::IsFinished(vtkRenderer* renderer)
{
  return this->GetUpdatesDone(renderer) >= this->Updates;
}

int vtkGIDDGI::GetUpdatesDone(vtkRenderer* renderer)
{
  const auto found = this->Impl->Fields.lower_bound({ renderer, 0 });
  return found != this->Impl->Fields.end() && found->first.first == renderer ? found->second.Updates
                                                                             : 0;
}

void vtkGIDDGI::GetGrid(vtkRenderer* renderer, int counts[3])
{
  const auto found = this->Impl->Fields.lower_bound({ renderer, 0 });
  for (int axis = 0; axis < 3; ++axis)
  {
    counts[axis] = found != this->Impl->Fields.end() && found->first.first == renderer
      ? found->second.Grid.Counts[axis]
      : 0;
  }
}
