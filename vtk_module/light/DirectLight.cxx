// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/DirectLight.h"

#include "capture/MaterialTable.h"
#include "gpu/ScopedState.h"
#include "light/LightTable.h"

namespace penumbra
{
namespace
{
struct Resolve
{
  LightTable* Lights;
  MaterialTable* Materials;
  DirectLightOptions Options;

  Defines Variant(const FrameContext& context, bool radiance, bool lit) const
  {
    Defines defines;
    const auto flag = [&defines](const char* name, bool set) {
      if (set)
      {
        defines[name] = "1";
      }
    };
    flag("GI_EXTENDED", this->Options.Extended);
    flag("GI_SPECULAR", this->Materials->HasSpecular());
    flag("GI_HEADLIGHT", this->Lights->IsSingleHeadlight());
    flag("GI_POSITIONAL", this->Lights->HasPositional());
    flag("GI_AREA", this->Lights->HasAreas());
    flag("GI_SURROUNDINGS",
      context.Input(resource::Irradiance) && context.Input(resource::Surroundings));
    flag("GI_INTERREFLECTION",
      context.Input(resource::AmbientVisibility) && this->Options.Interreflection > 0.0);
    flag("GI_CATCHER", this->Materials->HasCatcher());
    flag("GI_COVERAGE", this->Materials->HasPartialCoverage());
    flag("GI_RADIANCE", radiance);
    flag("GI_LIT", lit && this->Options.LitRadiance);
    flag("GI_LIT_PARTS", lit && this->Options.LitParts);
    flag("GI_DATA_COLORS", this->Options.Rules.ChangesData());
    flag("GI_DISPLAY", this->Options.Display && !radiance);
    return defines;
  }

  void operator()(FrameContext& context) const
  {
    // The window's own texture has the background already.
    if (!context.Output(resource::Color)->IsBorrowed())
    {
      context.CopyWindow(resource::Color);
    }
    if (this->Options.Radiance)
    {
      this->StartRadiance(context);
      this->Draw(context, { resource::Radiance });
    }
    if (this->Options.LitRadiance && this->Materials->HasPartialCoverage())
    {
      context.CopyWindow(resource::LitRadiance);
    }
    std::vector<const char*> targets = { resource::Color };
    if (this->Options.LitRadiance)
    {
      targets.push_back(resource::LitRadiance);
    }
    if (this->Options.LitParts)
    {
      targets.insert(targets.end(), { resource::LitShown, resource::LitEncoded });
      ScopedState scope(context.State());
      context.BindTarget({ resource::LitShown, resource::LitEncoded });
      const GLfloat nothing[] = { 0.0f, 0.0f, 0.0f, 0.0f };
      glClearBufferfv(GL_COLOR, 0, nothing);
      glClearBufferfv(GL_COLOR, 1, nothing);
    }
    this->Draw(context, targets);
  }

  // Start the radiance with the sky, or with the content of the window.
  static void StartRadiance(FrameContext& context)
  {
    const Texture* sky = context.Input(resource::Sky);
    if (!sky)
    {
      context.CopyWindow(resource::Radiance);
      return;
    }
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, false);
    context.BindTarget({ resource::Radiance });
    context.DrawBound("direct_light/sky.frag", {}, {});
  }

  void Draw(FrameContext& context, const std::vector<const char*>& targets) const
  {
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, this->Materials->HasPartialCoverage());
    context.State()->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    const bool radiance = targets.front() == resource::Radiance;
    Defines variant = this->Variant(context, radiance, targets.size() > 1);
    Arguments arguments;
    arguments.Set("ambientLight", glm::vec3(this->Options.SpreadShare * this->Lights->TotalColor()))
      .Set("interreflection", this->Options.Interreflection);
    const Texture* presented = radiance ? nullptr : context.PresentedDepth();
    if (presented)
    {
      context.BindTarget(context.Attachments(targets), { presented, -1 });
      variant["GI_PRESENT_DEPTH"] = "1";
      arguments.Set("depthWindow", glm::vec2(context.GetView().DepthWindow));
    }
    else
    {
      context.BindTarget(targets, resource::Depth);
    }
    // The triangle lies at the far plane, so only pixels with nearer surfaces are resolved. The window's depth has none yet:
    // there the shader discards pixels without a surface.
    scope.Set(GL_DEPTH_TEST, true);
    scope.DepthFunc(presented ? GL_ALWAYS : GL_GREATER);
    scope.DepthMask(presented != nullptr);
    context.DrawBound("direct_light/resolve.frag", variant, arguments);
  }
};

// Copy to the window what the previous passes could not draw straight into it. All samples of a pixel get the same values:
// the colour everywhere, the depth where a surface was captured.
void Present(FrameContext& context)
{
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, false);
  if (!context.Input(resource::Color)->IsBorrowed())
  {
    context.DrawBound("lib/copy_color.frag", {}, {});
  }
  if (context.Input(resource::Depth)->IsBorrowed() || context.PresentedDepth())
  {
    return;
  }
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthFunc(GL_ALWAYS);
  scope.DepthMask(true);
  scope.ColorMask(false);
  context.DrawBound("direct_light/present_depth.frag", {},
    Arguments().Set("depthWindow", glm::vec2(context.GetView().DepthWindow)));
}
}

namespace
{
/// The table of linearly transformed cosines for the highlights of lights that have an area.
History& HighlightTable(Frame& frame)
{
  constexpr int size = 16;
  History& table = frame.Keep("direct-light.highlights", { GL_RGBA32F, size, size, 2 });
  if (!table.Written)
  {
    for (const GLenum direction : { GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER })
    {
      table.Storage.SetParameter(direction, GL_LINEAR);
    }
    for (const GLenum direction : { GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T })
    {
      table.Storage.SetParameter(direction, GL_CLAMP_TO_EDGE);
    }
    frame.AddPass("highlight-table")
      .WriteHistory(table, "table")
      .Compute("direct_light/highlight_table.comp", {}, {}, Work::Items(size, size));
  }
  return table;
}
}

void ContributeDirectLight(
  Frame& frame, LightTable& lights, MaterialTable& materials, const DirectLightOptions& options)
{
  History* highlights = options.Extended && lights.HasAreas() ? &HighlightTable(frame) : nullptr;
  auto& pass = frame.AddPass("direct-light");
  pass.Read(resource::Depth)
    .Read(resource::DepthCopy)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .ReadIfPresent(resource::Ambient, "GI_AMBIENT")
    .ReadIfPresent(resource::Surface)
    .ReadIfPresent(resource::Emission)
    .ReadIfPresent(resource::DirectVisibility, "GI_DIRECT_VISIBILITY")
    .ReadIfPresent(resource::Irradiance, "GI_IRRADIANCE")
    .ReadIfPresent(resource::Surroundings)
    .ReadIfPresent(resource::LampLight, "GI_LAMP_LIGHT")
    .Offer(lights.InView(1.0 - options.SpreadShare))
    .Offer(materials.ShaderArguments())
    .Offer(options.Rules.ShaderArguments())
    .Write(resource::Color, frame.WindowTexture(GL_RGBA8))
    .SideEffect();
  if (options.Display)
  {
    pass.Offer(*options.Display);
  }
  if (options.AmbientLight)
  {
    pass.ReadIfPresent(resource::AmbientVisibility, "GI_AMBIENT_VISIBILITY");
  }
  if (highlights)
  {
    pass.ReadHistory(*highlights, "highlightTable");
  }
  if (options.Radiance)
  {
    pass.ReadIfPresent(resource::Sky);
    pass.Write(resource::Radiance, frame.WindowTexture(GL_RGBA32F));
  }
  if (options.LitRadiance)
  {
    pass.Write(
      resource::LitRadiance, frame.WindowTexture(options.Radiance ? GL_RGBA32F : GL_RGBA16F));
  }
  if (options.LitParts)
  {
    const TextureDesc desc = frame.WindowTexture(options.Radiance ? GL_RGBA32F : GL_RGBA16F);
    pass.Write(resource::LitShown, desc).Write(resource::LitEncoded, desc);
  }
  pass.Execute(Resolve{ &lights, &materials, options });
}

void ContributeBackdrop(Frame& frame)
{
  frame.AddPass("backdrop")
    .Write(resource::Backdrop, frame.WindowTexture(GL_RGBA8))
    .Execute([](FrameContext& context) { context.CopyWindow(resource::Backdrop); });
}

void ContributePresentation(Frame& frame, MaterialTable& materials)
{
  frame.AddPass("present")
    .Read(resource::Color)
    .Read(resource::Depth)
    .Read(resource::DepthCopy)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Offer(materials.ShaderArguments())
    .SideEffect()
    .Execute(Present);
}
}
