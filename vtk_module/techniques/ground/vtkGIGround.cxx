// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIGround.h"

#include "base/Matrices.h"
#include "capture/MaterialTable.h"
#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"
#include "techniques/ground/GroundPlane.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderer.h"

vtkStandardNewMacro(vtkGIGround);

using namespace penumbra;

vtkGIGround::vtkGIGround() = default;
vtkGIGround::~vtkGIGround() = default;

namespace
{
enum Kinds
{
  Catcher,
  Surface
};

// Places among the passes that modify the picture: shadows before reflections, the rim after everything that lights it.
constexpr int CatchOrder = 100;
constexpr int AlphaOrder = 750;
constexpr int RimOrder = 760;

// Number of the ground among the props, for reprojection: the largest, which no prop gets soon.
constexpr int GroundNumber = (1 << 24) - 1;

// The ground of a view.
struct Placement
{
  GroundPlane Plane;
  bool Seen = false;
  glm::dvec3 CameraUp{ 0.0 }; ///< up by the camera, decided when the ground is first drawn
  int LastFrame = -2;
  glm::dvec3 OpenLight{ 0.0 };   ///< see OpenSkyLight()
  glm::dvec3 OpenLightUp{ 0.0 }; ///< for which it was computed
};

glm::dvec3 AxisOf(int up)
{
  glm::dvec3 axis(0.0);
  axis[(up - 1) % 3] = up > 3 ? -1.0 : 1.0;
  return axis;
}

const Shape Square = { "ground/square.vert", 6 };

// A pass that knows the ground's pixels.
PassDeclaration& AddGroundPass(FrameBuilder& frame, const char* picture, int order)
{
  return frame.AddPass("ground-" + std::to_string(order) + "-" + picture)
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Offer(frame.Capture().Materials().ShaderArguments());
}

// Such a pass that modifies a picture where it is present.
PassDeclaration& AddPassOver(FrameBuilder& frame, const char* picture, int order)
{
  PassDeclaration& pass = AddGroundPass(frame, picture, order);
  return picture == resource::Color ? pass.Modify(picture, order, "before")
                                    : pass.ModifyIfPresent(picture, order, "before");
}

// Multiply what a picture shows of the ground. Alpha is handled as if black were blended over it.
void CatchShadows(FrameContext& context, const char* picture, const Arguments& arguments)
{
  ScopedState scope(context.State());
  context.BindTarget({ picture }, resource::Depth);
  scope.Set(GL_BLEND, true);
  context.State()->vtkglBlendFuncSeparate(
    GL_ZERO, GL_SRC_COLOR, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthFunc(GL_EQUAL);
  scope.DepthMask(false);
  context.DrawBound("ground/catch.frag", {}, arguments, Square);
}

// Up of a view if the user leaves it to us.
glm::dvec3 AutomaticUp(vtkOpenGLRenderer* renderer, const View& view, Placement& placement)
{
  if (placement.LastFrame != view.FrameNumber - 1 && placement.LastFrame != view.FrameNumber)
  {
    placement.CameraUp = NearestAxis(ToVec3(renderer->GetActiveCamera()->GetViewUp()));
  }
  placement.LastFrame = view.FrameNumber;
  return renderer->GetUseImageBasedLighting() ? NearestAxis(ToVec3(renderer->GetEnvironmentUp()))
                                              : placement.CameraUp;
}
}

void vtkGIGround::Plan(LightingPlan&, FrameBuilder& frame)
{
  const View& view = frame.GetView();
  auto& placement = frame.ViewState<Placement>(this);
  const glm::dvec3 automatic = AutomaticUp(frame.GetRenderer(), view, placement);
  placement.Seen = false;
  if (view.Diagonal <= 0.0 || this->Strength <= 0.0)
  {
    return;
  }
  placement.Plane = GroundPlane::Below(
    view.Bounds, this->Up > 0 ? AxisOf(this->Up) : automatic, this->Offset, this->Size);
  placement.Seen = placement.Plane.IsSeen(view);
  if (placement.Seen)
  {
    const glm::dvec2 range = placement.Plane.DepthRange(view);
    const RayPart part = placement.Plane.MakeRayPart({ this->Red, this->Green, this->Blue });
    frame.AddSurface(
      placement.Plane.Bounds(), range.x, range.y, this->Kind == Surface ? &part : nullptr);
  }
}

void vtkGIGround::Contribute(FrameBuilder& frame)
{
  const auto& placement = frame.ViewState<Placement>(this);
  if (!placement.Seen)
  {
    return;
  }
  const bool catches = this->Kind == Catcher;
  const int material = frame.Capture().Materials().Add({ glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
    glm::ivec4(catches ? GI_MATERIAL_CATCHER : GI_MATERIAL_PHONG, 0, 0, GroundNumber) });
  const Arguments plane = placement.Plane.InView(frame.GetView());
  frame.Capture().AddSurface(Square, "ground/surface.frag",
    Arguments(plane)
      .Set("hides", !catches)
      .Set("color", glm::vec3(this->Red, this->Green, this->Blue))
      .Set("material", material));
  if (!catches)
  {
    this->ContributeRim(frame, material);
  }
  else if (frame.Plan().IsDrawnByRays())
  {
    this->ContributeTraced(frame);
  }
  else
  {
    this->ContributeCatcher(frame);
  }
}

void vtkGIGround::ContributeCatcher(FrameBuilder& frame)
{
  const double share = frame.Plan().SpreadShare();
  auto& placement = frame.ViewState<Placement>(this);
  if (placement.OpenLightUp != placement.Plane.Up || frame.GetView().Changes.Lights)
  {
    placement.OpenLightUp = placement.Plane.Up;
    placement.OpenLight = OpenSkyLight(frame.GetRenderer(), placement.Plane.Up);
  }
  const Arguments arguments = placement.Plane.InView(frame.GetView())
                                .Set("ambientLight", glm::vec3(share * frame.Lights().TotalColor()))
                                .Set("openLight", glm::vec3(placement.OpenLight));
  for (const char* picture : { resource::Color, resource::LitRadiance, resource::Radiance })
  {
    AddGroundPass(frame, picture, CatchOrder)
      .DrawOverIfPresent(picture, CatchOrder)
      .Read(resource::Depth)
      .ReadIfPresent(resource::DirectVisibility, "GI_DIRECT_VISIBILITY")
      .ReadIfPresent(resource::AmbientVisibility, "GI_AMBIENT_VISIBILITY")
      .ReadIfPresent(resource::Irradiance, "GI_IRRADIANCE")
      .Offer(frame.Lights().InView(1.0 - share))
      .Execute([picture, arguments](FrameContext& context) {
        CatchShadows(context, picture, arguments);
      });
  }
}

// The path tracer averages over what it finds in the picture where its paths leave the scene, but not over alpha.
void vtkGIGround::ContributeTraced(FrameBuilder& frame)
{
  RayProps& rays = frame.Rays("they cast no shadow on the ground");
  const View& view = frame.GetView();
  History& alphas = frame.Keep("ground.alpha", frame.WindowTexture(GL_RGBA32F));
  const Arguments plane = frame.ViewState<Placement>(this).Plane.InView(view);
  AddPassOver(frame, resource::Color, CatchOrder)
    .UpdateHistory(alphas, "alphas")
    .Offer(rays.ShaderArguments())
    .Offer(frame.Lights().InWorld(rays.Origin()))
    .Offer(view.ToScene(rays.Origin()))
    .Execute([&rays, &alphas, plane](FrameContext& context) {
      Defines variant = rays.ShaderDefines();
      if (!alphas.Written || context.GetView().StillFrames == 0)
      {
        variant["GI_FIRST"] = "1";
      }
      context.Draw("ground/trace.frag", variant, plane);
    });
  for (const char* picture : { resource::Color, resource::Radiance })
  {
    AddPassOver(frame, picture, AlphaOrder)
      .ReadHistory(alphas, "alphas")
      .Draw("ground/alpha.frag", {}, {});
  }
}

void vtkGIGround::ContributeRim(FrameBuilder& frame, int material)
{
  const Arguments arguments =
    frame.ViewState<Placement>(this).Plane.InView(frame.GetView()).Set("material", material);
  for (const char* picture : { resource::Color, resource::Radiance })
  {
    const bool shown = picture == resource::Color;
    AddPassOver(frame, picture, RimOrder)
      .Read(resource::Backdrop)
      .ReadIfPresent(resource::Sky, "GI_SKY")
      .Draw("ground/rim.frag", shown ? Defines() : Defines{ { "GI_RADIANCE", "1" } }, arguments);
  }
}
