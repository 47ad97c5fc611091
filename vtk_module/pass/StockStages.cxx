// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/StockStages.h"

#include "vtkCamera.h"
#include "vtkFXAAOptions.h"
#include "vtkHardwareSelector.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"

namespace penumbra
{
namespace
{
// The list that limits a pick has no accessor, but a derived class can name the member.
struct PickList : public vtkViewport
{
  static vtkPropCollection* Of(vtkViewport* viewport)
  {
    return viewport->*(&PickList::PickFromProps);
  }
};

// CPU volume mappers read the depth buffer only if the renderer's count of drawn props is not 0.
struct PropCount : public vtkRenderer
{
  static int& Of(vtkRenderer* renderer) { return renderer->*(&PropCount::NumberOfPropsRendered); }
};

// The renderer's translucent stage always uses the renderer's own list of props.
struct PropList : public vtkRenderer
{
  static vtkProp**& Items(vtkRenderer* renderer) { return renderer->*(&PropList::PropArray); }
  static int& Count(vtkRenderer* renderer) { return renderer->*(&PropList::PropArrayCount); }
};
}

StockStages::StockStages(const vtkRenderState* state)
  : State(state)
  , Renderer(static_cast<vtkOpenGLRenderer*>(state->GetRenderer()))
{
}

void StockStages::UpdateCameraAndLights()
{
  this->Renderer->GetActiveCamera()->Render(this->Renderer);
  if (this->Renderer->GetLightFollowCamera())
  {
    this->Renderer->UpdateLightsGeometryToFollowCamera();
  }
  this->Renderer->UpdateLights();
}

bool StockStages::RenderSelection()
{
  vtkHardwareSelector* selector = this->Renderer->GetSelector();
  if (!selector)
  {
    return false;
  }
  if (vtkPropCollection* pickList = PickList::Of(this->Renderer))
  {
    std::vector<vtkProp*> props;
    vtkCollectionSimpleIterator cookie;
    pickList->InitTraversal(cookie);
    while (vtkProp* prop = pickList->GetNextProp(cookie))
    {
      if (prop->GetVisibility())
      {
        props.push_back(prop);
      }
    }
    this->Rendered = selector->Render(this->Renderer, props.data(), static_cast<int>(props.size()));
  }
  else
  {
    this->Rendered = selector->Render(
      this->Renderer, this->State->GetPropArray(), this->State->GetPropArrayCount());
  }
  return true;
}

bool StockStages::NeedsStockOpaque() const
{
  return this->Renderer->GetUseHiddenLineRemoval() &&
    vtkHiddenLineRemovalPass::WireframePropsExist(
      this->State->GetPropArray(), this->State->GetPropArrayCount());
}

void StockStages::RenderOpaque()
{
  vtkProp** props = this->State->GetPropArray();
  this->WithProps({ props, props + this->State->GetPropArrayCount() },
    [this] { this->Renderer->DeviceRenderOpaqueGeometry(); });
}

template <typename Draw>
void StockStages::WithProps(std::vector<vtkProp*> props, const Draw& draw)
{
  vtkProp**& items = PropList::Items(this->Renderer);
  int& count = PropList::Count(this->Renderer);
  vtkProp** const allItems = items;
  const int itemCount = count;
  items = props.data();
  count = static_cast<int>(props.size());
  draw();
  items = allItems;
  count = itemCount;
}

void StockStages::RenderAfterOpaque(int opaque, vtkOpenGLFXAAFilter* fxaa)
{
  PropCount::Of(this->Renderer) = opaque + this->Rendered;
  vtkProp** props = this->State->GetPropArray();
  const int count = this->State->GetPropArrayCount();
  std::vector<vtkProp*> layers(props, props + count);
  if (this->IsExcluded)
  {
    layers.erase(std::remove_if(layers.begin(), layers.end(), this->IsExcluded), layers.end());
  }
  const bool translucent = std::any_of(layers.begin(), layers.end(),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry(); });
  if (translucent)
  {
    this->WithProps(layers, [this] { this->Renderer->DeviceRenderTranslucentPolygonalGeometry(); });
  }
  if (this->Renderer->GetRenderWindow()->GetAbortRender())
  {
    return;
  }
  // VTK's filter fails on a multisampled window, because it copies the multisampled depth buffer. It is not needed
  // there either, as edges are already smooth.
  if (this->Renderer->GetUseFXAA() && this->Renderer->GetRenderWindow()->GetMultiSamples() <= 1)
  {
    if (vtkFXAAOptions* options = this->Renderer->GetFXAAOptions())
    {
      fxaa->UpdateConfiguration(options);
    }
    fxaa->Execute(this->Renderer);
  }
  const bool peeledVolumes = translucent && this->Renderer->GetUseDepthPeeling() &&
    this->Renderer->GetUseDepthPeelingForVolumes();
  if (!peeledVolumes)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Rendered += props[i]->RenderVolumetricGeometry(this->Renderer);
    }
  }
  for (int i = 0; i < count; ++i)
  {
    this->Rendered += props[i]->RenderOverlay(this->Renderer);
  }
  PropCount::Of(this->Renderer) = opaque + this->Rendered;
}
}
