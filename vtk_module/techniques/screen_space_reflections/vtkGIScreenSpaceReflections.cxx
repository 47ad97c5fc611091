// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIScreenSpaceReflections.h"

#include "capture/MaterialTable.h"
#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"

#include "reflection.h"

#include <array>

vtkStandardNewMacro(vtkGIScreenSpaceReflections);

using namespace penumbra;

namespace
{
constexpr const char* Pyramid = "screen-space-reflections.pyramid";
constexpr const char* Rays = "screen-space-reflections.rays";
constexpr const char* FoundLight = "screen-space-reflections.found";
constexpr const char* Ends = "screen-space-reflections.ends";

// Among the passes that modify the picture: before those that average it.
constexpr int CompositeOrder = 300;

// Part of the scene's diagonal that the automatic thickness takes.
constexpr double AutomaticThickness = 0.001;

constexpr int TableSize = 32;
constexpr int Neighbours = 12; // whose rays a pixel shares

enum FallbackValues
{
  None,
  Environment,
  ByRays
};

int GroupsOf(int size, int group)
{
  return (size + group - 1) / group;
}

/// Where the levels of the depth pyramid lie in its texture: the first at the origin, the others in a
/// column beside it. The last entry is the size of the texture.
std::array<glm::ivec2, GI_PYRAMID_LEVELS + 2> PyramidLayout(const glm::ivec4& viewport)
{
  std::array<glm::ivec2, GI_PYRAMID_LEVELS + 2> layout{};
  int height = 0;
  for (int level = 1; level <= GI_PYRAMID_LEVELS; ++level)
  {
    layout[level] = { viewport.z, height };
    height += GroupsOf(viewport.w, 1 << level);
  }
  layout.back() = { viewport.z + GroupsOf(viewport.z, 2), std::max(viewport.w, height) };
  return layout;
}

struct Reflector
{
  Texture* Table;
  MaterialTable* Materials;
  LightTable* Lights;
  bool Extended;
  int Samples;
  int Steps;
  double Thickness;
  double EdgeFade;
  double MaximumRoughness;
  double MinimumReflectance;
  int Neighbours;
  int Fallback;
  int DebugView;
  double Share;    ///< of the lights' strength that is spread over all directions
  RayProps* World; ///< nullptr without rays

  Defines Variant() const
  {
    Defines defines;
    if (this->Extended)
    {
      defines["GI_EXTENDED"] = "1";
    }
    return defines;
  }

  /// Bind the surface's lobe and up to two more textures.
  void Use(FrameContext& context, const Program& program, std::vector<const Texture*> more) const
  {
    std::vector<const Texture*> textures = { context.Input(resource::WindowDepth),
      context.Input(resource::Albedo), context.Input(resource::Normal),
      context.Input(resource::Surface), this->Table };
    textures.insert(textures.end(), more.begin(), more.end());
    context.Use(program, textures);
    this->Materials->Bind(1);
    glUniform1f(program.Location("maximumRoughness"), static_cast<GLfloat>(this->MaximumRoughness));
    glUniform1f(
      program.Location("minimumReflectance"), static_cast<GLfloat>(this->MinimumReflectance));
  }

  static void SetLevels(const FrameContext& context, const Program& program)
  {
    const auto layout = PyramidLayout(context.GetView().Viewport);
    glUniform2iv(program.Location("levelOffset"), GI_PYRAMID_LEVELS + 1, &layout[0].x);
  }

  void ReducePyramid(FrameContext& context) const
  {
    const glm::ivec4& area = context.GetView().Viewport;
    const Program& program =
      context.Shaders().Compute("screen_space_reflections/depth_pyramid.comp");
    context.Use(program, { context.Input(resource::WindowDepth), context.Input(resource::Normal) });
    SetLevels(context, program);
    glUniform1f(program.Location("thickness"), static_cast<GLfloat>(this->Thickness));
    glBindImageTexture(0, context.Output(Pyramid)->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    constexpr int pixels = 4 * GI_PYRAMID_GROUP;
    glDispatchCompute(GroupsOf(area.z, pixels), GroupsOf(area.w, pixels), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  }

  /// The shares of light that lobes reflect; once for all frames.
  static void FillTable(FrameContext& context, const Texture& table)
  {
    context.Use(context.Shaders().Compute("screen_space_reflections/lobe_table.comp"), {});
    glBindImageTexture(0, table.Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    glDispatchCompute(TableSize / 8, TableSize / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  }

  void Trace(FrameContext& context) const
  {
    const View& view = context.GetView();
    Defines defines = this->Variant();
    if (this->World)
    {
      defines.merge(this->World->ShaderDefines());
      defines["GI_FALLBACK_RAYS"] = "1";
    }
    if (this->DebugView)
    {
      defines["GI_DEBUG"] = "1";
    }
    const Program& program =
      context.Shaders().Compute("screen_space_reflections/trace.comp", defines);
    this->Use(context, program, { context.Input(Pyramid), context.Input(resource::LitRadiance) });
    if (this->World)
    {
      this->BindWorld(context, program);
    }
    SetLevels(context, program);
    glUniform1i(program.Location("maximumSteps"), this->Steps);
    glUniform1i(program.Location("samples"), this->Samples);
    glUniform1f(program.Location("reach"), static_cast<GLfloat>(view.Diagonal));
    glUniform1f(program.Location("thickness"), static_cast<GLfloat>(this->Thickness));
    glUniform1f(program.Location("edgeFade"), static_cast<GLfloat>(this->EdgeFade));
    glBindImageTexture(0, context.Output(Rays)->Get(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(
      1, context.Output(FoundLight)->Get(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    if (this->DebugView)
    {
      glBindImageTexture(2, EndTexture(context).Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    }
    constexpr int group = 8;
    glDispatchCompute(GroupsOf(view.Viewport.z, group), GroupsOf(view.Viewport.w, group), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  }

  void BindWorld(FrameContext& context, const Program& program) const
  {
    const View& view = context.GetView();
    this->World->Bind(program);
    this->Lights->BindWorld(0, this->World->Origin());
    const glm::mat3 rotation(glm::dmat3(view.ViewToWorld));
    const glm::vec3 eye(glm::dvec3(view.ViewToWorld[3]) - this->World->Origin());
    glUniformMatrix3fv(program.Location("viewToScene"), 1, GL_FALSE, &rotation[0][0]);
    glUniform3fv(program.Location("eye"), 1, &eye[0]);
    glUniform1i(program.Location("lightCount"), static_cast<GLint>(this->Lights->Lights().size()));
    glUniform1f(program.Location("lampShare"), static_cast<GLfloat>(1.0 - this->Share));
    this->SetAmbientLight(program);
  }

  void SetAmbientLight(const Program& program) const
  {
    const glm::vec3 ambient(this->Share * this->Lights->TotalColor());
    glUniform3fv(program.Location("ambientLight"), 1, &ambient[0]);
  }

  /// How rays ended, kept for those who ask vtkGIPass::GetBuffer for it.
  static Texture& EndTexture(FrameContext& context)
  {
    const glm::ivec2& size = context.GetView().WindowSize;
    bool fresh = false;
    return context.History(Ends, { GL_RGBA32F, size.x, size.y, 0 }, fresh);
  }

  void Reuse(FrameContext& context) const
  {
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, false);
    scope.DepthMask(false);
    context.BindTarget({ resource::Reflection });
    const Program& program =
      context.Shaders().Fragment("screen_space_reflections/reuse.frag", this->Variant());
    this->Use(context, program, { context.Input(Rays), context.Input(FoundLight) });
    glUniform1i(program.Location("samples"), this->Samples);
    glUniform1i(program.Location("neighbours"), this->Neighbours);
    context.DrawFullscreen();
  }

  void Composite(FrameContext& context, const char* target) const
  {
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, false);
    scope.DepthMask(false);
    Defines defines = this->Variant();
    const auto flag = [&defines](const char* name, bool set) {
      if (set)
      {
        defines[name] = "1";
      }
    };
    flag("GI_SURROUNDINGS", context.Input(resource::Surroundings) != nullptr);
    flag("GI_AMBIENT_VISIBILITY", context.Input(resource::AmbientVisibility) != nullptr);
    flag("GI_RADIANCE", target == resource::Radiance);
    flag("GI_DEBUG", this->DebugView != 0);
    const Program& program =
      context.Shaders().Fragment("screen_space_reflections/composite.frag", defines);
    context.BindTarget({ target });
    this->Use(context, program,
      { context.Input(target), context.Input(resource::LitRadiance),
        context.Input(resource::Reflection), context.Input(resource::Surroundings),
        context.Input(resource::AmbientVisibility),
        this->DebugView ? &EndTexture(context) : nullptr });
    glUniform1i(program.Location("debugMode"), this->DebugView);
    glUniform1f(program.Location("keep"), this->Fallback == None ? 0.0f : 1.0f);
    this->SetAmbientLight(program);
    context.DrawFullscreen();
  }
};

PassDeclaration& ReadLobe(PassDeclaration& pass)
{
  return pass.Read(resource::WindowDepth)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .ReadIfPresent(resource::Surface);
}

PassDeclaration& ReadReflection(PassDeclaration& pass)
{
  return ReadLobe(pass)
    .Read(resource::LitRadiance)
    .Read(resource::Reflection)
    .ReadIfPresent(resource::Surroundings)
    .ReadIfPresent(resource::AmbientVisibility);
}
}

struct vtkGIScreenSpaceReflections::Resources
{
  std::unique_ptr<Texture> Table;
};

vtkGIScreenSpaceReflections::vtkGIScreenSpaceReflections()
  : Impl(new Resources)
{
}

vtkGIScreenSpaceReflections::~vtkGIScreenSpaceReflections() = default;

void vtkGIScreenSpaceReflections::ReleaseGraphicsResources(vtkWindow*)
{
  *this->Impl = Resources();
}

const char* vtkGIScreenSpaceReflections::GetOfferedResource()
{
  return resource::Reflection;
}

void vtkGIScreenSpaceReflections::Contribute(FrameBuilder& frame)
{
  const View& view = frame.GetView();
  if (view.Diagonal <= 0.0 || !frame.Capture().Reflects(this->MinimumReflectance))
  {
    return;
  }
  frame.RequestLitRadiance();
  const double thickness =
    this->Thickness > 0.0 ? this->Thickness : AutomaticThickness * view.Diagonal;
  const Reflector reflector = { nullptr, &frame.Capture().Materials(), &frame.Lights(),
    frame.Capture().IsExtended(), this->Samples, this->MaximumSteps, thickness, this->EdgeFade,
    this->MaximumRoughness, this->MinimumReflectance, this->Filter ? Neighbours : 0, this->Fallback,
    this->DebugView, frame.Plan().SpreadShare(), this->Fallback == ByRays ? &frame.Rays() : nullptr };
  if (reflector.World && reflector.World->LeftOut() > 0)
  {
    frame.AddNote("rays do not see " + std::to_string(reflector.World->LeftOut()) +
      " props of kinds that cannot be traced yet: reflections show them on the screen only");
  }
  const auto bound = [this, reflector](FrameContext& context) {
    Reflector ready = reflector;
    if (!this->Impl->Table)
    {
      this->Impl->Table =
        std::make_unique<Texture>(TextureDesc{ GL_RGBA16F, TableSize, TableSize, 0 });
      this->Impl->Table->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
      this->Impl->Table->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
      Reflector::FillTable(context, *this->Impl->Table);
    }
    ready.Table = this->Impl->Table.get();
    return ready;
  };
  const glm::ivec2 size = PyramidLayout(view.Viewport).back();
  frame.AddPass("reflection-pyramid")
    .Read(resource::WindowDepth)
    .Read(resource::Normal)
    .Write(Pyramid, { GL_RG32F, size.x, size.y, 0 })
    .Execute([reflector](FrameContext& context) { reflector.ReducePyramid(context); });
  ReadLobe(frame.AddPass("reflection-trace"))
    .Read(Pyramid)
    .Read(resource::LitRadiance)
    .Write(Rays, frame.WindowTexture(GL_RGBA32F, this->Samples))
    .Write(FoundLight, frame.WindowTexture(GL_RGBA16F, this->Samples))
    .Execute([bound](FrameContext& context) { bound(context).Trace(context); });
  ReadLobe(frame.AddPass("reflection-reuse"))
    .Read(Rays)
    .Read(FoundLight)
    .Write(resource::Reflection, frame.WindowTexture(GL_RGBA16F))
    .Execute([bound](FrameContext& context) { bound(context).Reuse(context); });
  ReadReflection(frame.AddPass("reflection-composite"))
    .Modify(resource::Color, CompositeOrder)
    .Execute(
      [bound](FrameContext& context) { bound(context).Composite(context, resource::Color); });
  ReadReflection(frame.AddPass("reflection-composite-radiance"))
    .ModifyIfPresent(resource::Radiance, CompositeOrder)
    .Execute(
      [bound](FrameContext& context) { bound(context).Composite(context, resource::Radiance); });
}
