// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIShadowMaps.h"

#include "private/Frame.h"
#include "private/SceneCapture.h"
#include "private/ScopedState.h"
#include "private/ShadowViews.h"

#include "shadow.h"

#include "vtkProp.h"

vtkStandardNewMacro(vtkGIShadowMaps);

using namespace penumbra;

namespace
{
constexpr const char* Maps = "shadow-maps.maps";

/// The maps of a frame and the lights that own them.
struct Plan
{
  std::vector<ShadowView> Views;
  std::vector<shared::ShadowMapData> MapData;
  std::vector<shared::ShadowLightData> LightData;
  std::vector<double> Signature; ///< of what the maps show
};

// Clip space [-1, 1] to a map's [0, 1].
glm::dmat4 ToUnitCube()
{
  glm::dmat4 m(0.5);
  m[3] = { 0.5, 0.5, 0.5, 1.0 };
  return m;
}

void AddLight(Plan& plan, const Light& light, const View& view, int resolution, double radius)
{
  // The filter's disc, and a texel of hardware filtering around it.
  const ShadowViews fitted = FitShadowViews(light, view.Bounds, resolution, radius + 2.0);
  shared::ShadowLightData data;
  data.Direction = glm::vec4(light.Direction, 0.0);
  data.Position = glm::vec4(light.Position, light.Positional ? 1.0 : 0.0);
  data.Texel = glm::vec4(fitted.Texel, radius, 0.0, 0.0);
  data.Maps = glm::ivec4(plan.Views.size(), fitted.Views.size(), 0, 0);
  plan.LightData.push_back(data);
  for (const auto& map : fitted.Views)
  {
    plan.Views.push_back(map);
    plan.MapData.push_back(
      { glm::mat4(ToUnitCube() * map.ViewToClip * map.WorldToView * view.ViewToWorld) });
    for (const auto* matrix : { &map.WorldToView, &map.ViewToClip })
    {
      for (int i = 0; i < 16; ++i)
      {
        plan.Signature.push_back((*matrix)[i / 4][i % 4]);
      }
    }
  }
}
}

struct vtkGIShadowMaps::Resources
{
  Buffer MapBlock;
  Buffer LightBlock;
  std::map<const Texture*, std::vector<double>> Drawn; ///< what each kept map array shows
};

vtkGIShadowMaps::vtkGIShadowMaps()
  : Impl(new Resources)
{
}

vtkGIShadowMaps::~vtkGIShadowMaps() = default;

void vtkGIShadowMaps::ReleaseGraphicsResources(vtkWindow*)
{
  *this->Impl = Resources();
}

void vtkGIShadowMaps::Contribute(FrameBuilder& frame)
{
  this->ShadowedLights = 0;
  this->UnshadowedLights = 0;
  this->TexelWidth = 0.0;
  const View& view = frame.GetView();
  if (view.Diagonal <= 0.0)
  {
    return;
  }
  auto plan = std::make_shared<Plan>();
  const LightTable::Shadowed shadowed = frame.Lights().AssignMask(this->MaximumLights);
  this->ShadowedLights = static_cast<int>(shadowed.With.size());
  this->UnshadowedLights = shadowed.Without;
  for (const std::size_t index : shadowed.With)
  {
    AddLight(*plan, frame.Lights().Lights()[index], view, this->Resolution, this->FilterRadius);
  }
  if (this->UnshadowedLights > 0)
  {
    frame.AddNote(std::to_string(this->UnshadowedLights) + " of " +
      std::to_string(this->UnshadowedLights + this->ShadowedLights) +
      " lights cast no shadow: raise shadow-maps.maximum-lights for more.");
  }
  if (this->ShadowedLights == 0)
  {
    return;
  }
  this->TexelWidth = plan->LightData.front().Texel.x;
  SceneCapture& scene = frame.Capture();
  for (vtkProp* prop : scene.Casters())
  {
    plan->Signature.push_back(static_cast<double>(prop->GetRedrawMTime()));
    plan->Signature.push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop)));
  }

  const int layers = static_cast<int>(plan->Views.size());
  const TextureDesc mapDesc = { GL_DEPTH_COMPONENT32F, this->Resolution, this->Resolution, layers };
  const int maskLayers = (this->ShadowedLights + 3) / 4;
  frame.AddPass("shadow-maps")
    .Read(resource::Depth)
    .Read(resource::WindowDepth)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Write(resource::DirectVisibility, frame.WindowTexture(GL_RGBA8, maskLayers))
    .Execute([this, plan, &scene, mapDesc, maskLayers](FrameContext& context) {
      bool fresh = false;
      Texture& maps = context.History(Maps, mapDesc, fresh);
      if (fresh)
      {
        maps.SetParameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        maps.SetParameter(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        maps.SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        maps.SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
      }
      this->DrawnMaps = 0;
      auto& shown = this->Impl->Drawn[&maps];
      if (fresh || this->AlwaysRedraw || shown != plan->Signature)
      {
        shown = plan->Signature;
        for (const auto& map : plan->Views)
        {
          ScopedState scope(context.State());
          context.BindTarget({}, { &maps, this->DrawnMaps });
          scope.Viewport(0, 0, mapDesc.Width, mapDesc.Height);
          scope.Set(GL_DEPTH_TEST, true);
          scope.DepthFunc(GL_LEQUAL);
          scope.DepthMask(true);
          const GLfloat far = 1.0f;
          glClearBufferfv(GL_DEPTH, 0, &far);
          scene.DrawCasters(context.Renderer(), map.WorldToView, map.ViewToClip, map.Parallel);
          ++this->DrawnMaps;
        }
      }

      this->Impl->MapBlock.Upload(GL_SHADER_STORAGE_BUFFER, plan->MapData.data(),
        plan->MapData.size() * sizeof(plan->MapData[0]));
      this->Impl->LightBlock.Upload(GL_SHADER_STORAGE_BUFFER, plan->LightData.data(),
        plan->LightData.size() * sizeof(plan->LightData[0]));
      const Program& program = context.Shaders().Fragment("shadow_maps/mask.frag",
        { { "GI_SAMPLES", std::to_string(this->FilterRadius > 0.0 ? this->FilterSamples : 1) } });
      ScopedState scope(context.State());
      scope.Set(GL_BLEND, false);
      scope.Set(GL_DEPTH_TEST, true);
      scope.DepthFunc(GL_GREATER);
      scope.DepthMask(false);
      for (int layer = 0; layer < maskLayers; ++layer)
      {
        context.BindTarget({ { context.Output(resource::DirectVisibility), layer } },
          { context.Input(resource::Depth), -1 });
        context.Use(program,
          { context.Input(resource::WindowDepth), context.Input(resource::Albedo),
            context.Input(resource::Normal), &maps });
        this->Impl->MapBlock.BindBase(GL_SHADER_STORAGE_BUFFER, 2);
        this->Impl->LightBlock.BindBase(GL_SHADER_STORAGE_BUFFER, 3);
        glUniform1i(program.Location("firstLight"), layer * 4);
        glUniform1i(program.Location("lightCount"),
          std::min(4, static_cast<int>(plan->LightData.size()) - layer * 4));
        glUniform2f(program.Location("bias"), static_cast<GLfloat>(this->ConstantBias),
          static_cast<GLfloat>(this->SlopeBias));
        context.DrawFullscreen();
      }
    });
}
