// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGILightmap.h"

#include "bake/BakeFit.h"
#include "technique/FrameBuilder.h"
#include "techniques/lightmap/LightmapImage.h"
#include "techniques/lightmap/SurfaceMap.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPolyData.h"

#include <stdexcept>

vtkStandardNewMacro(vtkGILightmap);

using namespace penumbra;

struct vtkGILightmap::Internals
{
  SurfaceMap Map;
  BakedScene Scene; ///< the scene that was baked
};

vtkGILightmap::vtkGILightmap()
  : Impl(new Internals)
{
}

vtkGILightmap::~vtkGILightmap() = default;

bool vtkGILightmap::SetBake(vtkImageData* bake)
{
  this->Error.clear();
  try
  {
    auto next = std::make_unique<Internals>();
    if (bake)
    {
      lightmap_image::RequireWhole(bake);
      next->Map = SurfaceMap(bake);
      next->Scene = BakedScene::FromText(GetText(bake->GetFieldData(), BakedSceneText));
    }
    // GPU resources are freed when their context is current.
    next->Map.TakeResources(this->Impl->Map);
    this->Impl = std::move(next);
  }
  catch (const std::invalid_argument& error)
  {
    this->Error = error.what();
    return false;
  }
  this->Modified();
  return true;
}

bool vtkGILightmap::SetBake(vtkPolyData* surfaces, vtkImageData* light)
{
  vtkNew<vtkImageData> bake;
  return surfaces || light ? this->JoinBake(surfaces, light, bake) && this->SetBake(bake)
                           : this->SetBake(nullptr);
}

bool vtkGILightmap::JoinBake(vtkPolyData* surfaces, vtkImageData* light, vtkImageData* bake)
{
  this->Error.clear();
  try
  {
    lightmap_image::Join(surfaces, light, bake);
  }
  catch (const std::invalid_argument& error)
  {
    this->Error = error.what();
  }
  return this->Error.empty();
}

const char* vtkGILightmap::GetBakeError()
{
  return this->Error.c_str();
}

bool vtkGILightmap::HasBake()
{
  return !this->Impl->Map.IsEmpty();
}

bool vtkGILightmap::HasLampLight()
{
  return this->Impl->Map.HasDirectLight();
}

std::string vtkGILightmap::DescribeScene(vtkRenderer* renderer)
{
  BakedSceneCache cache;
  return renderer ? BakedScene::Of(renderer, cache).ToText() : std::string();
}

std::string vtkGILightmap::GetMismatch(vtkRenderer* renderer)
{
  const ViewState* view = this->Views ? this->Views->FindView(renderer) : nullptr;
  const BakeFit* fit = view ? view->Find<BakeFit>(this) : nullptr;
  return fit ? fit->Mismatch() : std::string();
}

void vtkGILightmap::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Map.Release();
}

void vtkGILightmap::Plan(LightingPlan& plan, FrameBuilder& frame)
{
  BakeFit& fit = frame.ViewState<BakeFit>(this);
  if (!this->HasBake())
  {
    fit = BakeFit();
    this->Impl->Map.Release(); // of a bake that was removed
    frame.AddNote("the lightmap is on without a bake: make one with penumbra bake lightmap");
    return;
  }
  fit.Check(frame, this->Impl->Scene, "the lightmap no longer fits");
  if (fit.Fits())
  {
    plan.AnnounceIndirectLight(IndirectKind::BakedOnSurfaces, 0.0);
  }
  else if (this->LiveFallback)
  {
    plan.RequestLiveLight();
  }
}

void vtkGILightmap::Contribute(FrameBuilder& frame)
{
  const BakeFit& fit = frame.ViewState<BakeFit>(this);
  if (!this->HasBake() || !fit.Fits())
  {
    return;
  }
  IndirectLight light;
  light.Kind = IndirectKind::BakedOnSurfaces;
  light.Declare = [](PassDeclaration& pass) {
    pass.Read(resource::DepthCopy).Read(resource::Normal);
  };
  light.Draw = [this, solid = fit.IsSolid()](
                 FrameContext& context) { this->Impl->Map.Draw(context, this->Intensity, solid); };
  light.IncludesDirectLight = this->Impl->Map.HasDirectLight();
  frame.AddIndirectLight(std::move(light));
}
