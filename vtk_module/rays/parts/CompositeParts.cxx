// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers of composite polygonal data: one part per block, with the block's display attributes.
#include "rays/parts/PolyDataParts.h"
#include "rays/parts/SurfaceMaterial.h"

#include "base/Matrices.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkLookupTable.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#if __has_include("vtkCompositePolyDataMapper2.h")
#include "vtkCompositePolyDataMapper2.h"
#define PENUMBRA_COMPOSITE_2 1
#endif

#include <optional>

namespace penumbra
{
namespace
{
// Before VTK 9.3 vtkCompositePolyDataMapper has no display attributes of blocks. Since 9.4 there is no
// vtkCompositePolyDataMapper2.
template <typename Mapper>
auto DisplayAttributesOf(Mapper* mapper, int)
  -> decltype(mapper->GetCompositeDataDisplayAttributes())
{
  return mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
}
template <typename Mapper>
vtkCompositeDataDisplayAttributes* DisplayAttributesOf(Mapper*, long)
{
  return nullptr;
}
template <typename Mapper>
auto UsesNanColor(Mapper* mapper, int) -> decltype(mapper->GetColorMissingArraysWithNanColor())
{
  return mapper && mapper->GetColorMissingArraysWithNanColor();
}
template <typename Mapper>
bool UsesNanColor(Mapper*, long)
{
  return false;
}

/// Since the VTK version in which blocks can have their own textures, scalars take precedence over a block's
/// colour.
template <typename DisplayAttributes>
auto ScalarsOverrideColor(DisplayAttributes* attributes, int)
  -> decltype(attributes->HasBlockTextures())
{
  return true;
}
template <typename DisplayAttributes>
bool ScalarsOverrideColor(DisplayAttributes*, long)
{
  return false;
}

std::optional<glm::dvec3> NanColor(vtkScalarsToColors* table)
{
  if (auto* lookup = vtkLookupTable::SafeDownCast(table))
  {
    return ToVec3(lookup->GetNanColor());
  }
  if (auto* function = vtkColorTransferFunction::SafeDownCast(table))
  {
    return ToVec3(function->GetNanColor());
  }
  return {};
}

class Blocks
{
public:
  Blocks(vtkMapper* mapper, const GatherContext& context)
    : Mapper(mapper)
    , Context(context)
  {
#ifdef PENUMBRA_COMPOSITE_2
    auto* second = vtkCompositePolyDataMapper2::SafeDownCast(mapper);
    this->DisplayAttributes = DisplayAttributesOf(second, 0);
    this->NanColorForMissing = UsesNanColor(second, 0);
#endif
    auto* first = vtkCompositePolyDataMapper::SafeDownCast(mapper);
    this->DisplayAttributes =
      this->DisplayAttributes ? this->DisplayAttributes : DisplayAttributesOf(first, 0);
    this->NanColorForMissing |= UsesNanColor(first, 0);
  }

  /// Display attributes that a block inherits from its parents.
  struct BlockStyle
  {
    bool Visible = true;
    std::optional<double> Opacity;
    std::optional<glm::dvec3> Color;
  };

  void Add(vtkDataObject* block, BlockStyle style)
  {
    if (this->DisplayAttributes && this->DisplayAttributes->HasBlockVisibility(block))
    {
      style.Visible = this->DisplayAttributes->GetBlockVisibility(block);
    }
    if (this->DisplayAttributes && this->DisplayAttributes->HasBlockOpacity(block))
    {
      style.Opacity = this->DisplayAttributes->GetBlockOpacity(block);
    }
    if (this->DisplayAttributes && this->DisplayAttributes->HasBlockColor(block))
    {
      double color[3];
      this->DisplayAttributes->GetBlockColor(block, color);
      style.Color = ToVec3(color);
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(block))
    {
      auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
      iterator->VisitOnlyLeavesOff();
      iterator->TraverseSubTreeOff();
      for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      {
        this->Add(iterator->GetCurrentDataObject(), style);
      }
    }
    else if (auto* data = vtkPolyData::SafeDownCast(block))
    {
      if (style.Visible && data->GetNumberOfPoints() > 0)
      {
        this->AddLeaf(data, style);
      }
    }
  }

private:
  void AddLeaf(vtkPolyData* data, const BlockStyle& style)
  {
    const ScalarColors& colors = MapScalarColors(this->Context.Cache, this->Mapper, data);
    RayPart part = PolyDataPart(this->Context, this->Mapper, data, colors);
    std::optional<glm::dvec3> color = style.Color;
    if (color && colors.Array && ScalarsOverrideColor(this->DisplayAttributes, 0))
    {
      color.reset();
    }
    if (this->NanColorForMissing && this->Mapper->GetScalarVisibility() && !colors.Array)
    {
      const auto nan = NanColor(this->Mapper->GetLookupTable());
      color = nan ? nan : color;
    }
    for (shared::RaySurface* surface : { &part.Surface, &part.Back })
    {
      if (color)
      {
        Recolor(*surface, this->Context.Actor->GetProperty(), glm::vec3(*color));
        surface->Where.z &= ~(GI_SURFACE_POINT_COLORS | GI_SURFACE_CELL_COLORS);
      }
      if (style.Opacity)
      {
        surface->Color.a = 1.0f;
        Fade(*surface, static_cast<float>(*style.Opacity));
      }
    }
    this->Context.Parts.push_back(std::move(part));
  }

  vtkMapper* Mapper;
  const GatherContext& Context;
  vtkCompositeDataDisplayAttributes* DisplayAttributes = nullptr;
  bool NanColorForMissing = false;
};
}

bool GatherComposite(vtkMapper* mapper, const GatherContext& context)
{
  UpdateInput(mapper);
  if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    if (vtkDataObject* input = mapper->GetInputDataObject(0, 0))
    {
      Blocks(mapper, context).Add(input, {});
    }
  }
  return true;
}
}
