// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGILightmap.h"

#include "bake/BakedScene.h"
#include "technique/FrameBuilder.h"
#include "techniques/lightmap/SurfaceMap.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <stdexcept>

vtkStandardNewMacro(vtkGILightmap);

using namespace penumbra;

struct vtkGILightmap::Internals
{
  SurfaceMap Map;
  BakedSceneWatch Watch;
  std::map<vtkRenderer*, std::string> Mismatches; ///< of renderers' last frames
};

vtkGILightmap::vtkGILightmap()
  : Impl(new Internals)
{
}

vtkGILightmap::~vtkGILightmap() = default;

bool vtkGILightmap::SetBake(vtkPolyData* surfaces, vtkImageData* light)
{
  try
  {
    auto next = std::make_unique<Internals>();
    if (surfaces || light)
    {
      next->Map = SurfaceMap(surfaces, light);
      auto* scene =
        vtkStringArray::SafeDownCast(surfaces->GetFieldData()->GetAbstractArray("scene"));
      next->Watch.SetBaked(scene && scene->GetNumberOfValues() == 1 ? scene->GetValue(0) : "");
    }
    // What is on the graphics card is freed when its context is current.
    next->Map.TakeOld(this->Impl->Map);
    this->Impl = std::move(next);
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro(<< "The lightmap cannot be used: " << error.what() << ".");
    return false;
  }
  this->Modified();
  return true;
}

bool vtkGILightmap::HasBake()
{
  return !this->Impl->Map.IsEmpty();
}

bool vtkGILightmap::HasLampLight()
{
  return this->Impl->Map.HasLamps();
}

std::string vtkGILightmap::DescribeScene(vtkRenderer* renderer)
{
  BakedSceneCache cache;
  return renderer ? BakedScene::Of(renderer, cache).ToText() : std::string();
}

std::string vtkGILightmap::GetMismatch(vtkRenderer* renderer)
{
  const auto found = this->Impl->Mismatches.find(renderer);
  return found == this->Impl->Mismatches.end() ? std::string() : found->second;
}

void vtkGILightmap::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Map.Release();
  this->Impl->Watch.Forget();
}

void vtkGILightmap::Contribute(FrameBuilder& frame)
{
  if (!this->HasBake())
  {
    frame.AddNote("the lightmap is on without a bake: make one with penumbra bake lightmap");
    return;
  }
  const View& view = frame.GetView();
  std::string& mismatch = this->Impl->Mismatches[frame.GetRenderer()];
  mismatch = this->Impl->Watch.Difference(
    frame.GetRenderer(), view.Changes.Props || view.Changes.Looks, view.FrameNumber);
  if (!mismatch.empty())
  {
    frame.AddNote("the lightmap no longer fits: " + mismatch + " since the bake");
    if (this->LiveFallback)
    {
      frame.RequestLiveLight();
    }
    return;
  }
  frame.AddIndirectLight(
    { IndirectKind::BakedOnSurfaces, 0.0, { resource::WindowDepth, resource::Normal },
      [this, solid = this->Impl->Watch.IsSolid(frame.GetRenderer())](
        FrameContext& context) { this->Impl->Map.Draw(context, this->Intensity, solid); },
      {}, this->Impl->Map.HasLamps() });
}
