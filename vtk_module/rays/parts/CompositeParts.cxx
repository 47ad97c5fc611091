// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers of trees of polygonal data: a part a block, with what the tree says of its looks.
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
// Before VTK 9.3 vtkCompositePolyDataMapper knows nothing of its blocks' looks, and from 9.4 on
// vtkCompositePolyDataMapper2 is gone.
template <typename Mapper>
auto Attributes(Mapper* mapper, int) -> decltype(mapper->GetCompositeDataDisplayAttributes())
{
  return mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
}
template <typename Mapper>
vtkCompositeDataDisplayAttributes* Attributes(Mapper*, long)
{
  return nullptr;
}
template <typename Mapper>
auto ColorsMissing(Mapper* mapper, int) -> decltype(mapper->GetColorMissingArraysWithNanColor())
{
  return mapper && mapper->GetColorMissingArraysWithNanColor();
}
template <typename Mapper>
bool ColorsMissing(Mapper*, long)
{
  return false;
}

/// From the version on whose blocks can have textures of their own, scalars win over a block's
/// colour.
template <typename Looks>
auto ScalarsWin(Looks* looks, int) -> decltype(looks->HasBlockTextures())
{
  return true;
}
template <typename Looks>
bool ScalarsWin(Looks*, long)
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
  Blocks(vtkMapper* mapper, const Drawn& drawn)
    : Mapper(mapper)
    , Out(drawn)
  {
#ifdef PENUMBRA_COMPOSITE_2
    auto* second = vtkCompositePolyDataMapper2::SafeDownCast(mapper);
    this->Looks = Attributes(second, 0);
    this->Missing = ColorsMissing(second, 0);
#endif
    auto* first = vtkCompositePolyDataMapper::SafeDownCast(mapper);
    this->Looks = this->Looks ? this->Looks : Attributes(first, 0);
    this->Missing |= ColorsMissing(first, 0);
  }

  /// What a block inherits from those above it.
  struct Look
  {
    bool Visible = true;
    std::optional<double> Opacity;
    std::optional<glm::dvec3> Color;
  };

  void Add(vtkDataObject* block, Look look)
  {
    if (this->Looks && this->Looks->HasBlockVisibility(block))
    {
      look.Visible = this->Looks->GetBlockVisibility(block);
    }
    if (this->Looks && this->Looks->HasBlockOpacity(block))
    {
      look.Opacity = this->Looks->GetBlockOpacity(block);
    }
    if (this->Looks && this->Looks->HasBlockColor(block))
    {
      double color[3];
      this->Looks->GetBlockColor(block, color);
      look.Color = ToVec3(color);
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(block))
    {
      auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
      iterator->VisitOnlyLeavesOff();
      iterator->TraverseSubTreeOff();
      for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      {
        this->Add(iterator->GetCurrentDataObject(), look);
      }
    }
    else if (auto* data = vtkPolyData::SafeDownCast(block))
    {
      if (look.Visible && data->GetNumberOfPoints() > 0)
      {
        this->AddLeaf(data, look);
      }
    }
  }

private:
  void AddLeaf(vtkPolyData* data, const Look& look)
  {
    const ScalarColors& colors = MapScalarColors(this->Out.Cache, this->Mapper, data);
    RayPart part = PolyDataPart(this->Out, this->Mapper, data, colors);
    std::optional<glm::dvec3> color = look.Color;
    if (color && colors.Array && ScalarsWin(this->Looks, 0))
    {
      color.reset();
    }
    if (this->Missing && this->Mapper->GetScalarVisibility() && !colors.Array)
    {
      const auto nan = NanColor(this->Mapper->GetLookupTable());
      color = nan ? nan : color;
    }
    for (shared::RaySurface* surface : { &part.Surface, &part.Back })
    {
      if (color)
      {
        Recolor(*surface, this->Out.Actor->GetProperty(), glm::vec3(*color));
        surface->Where.z &= ~(GI_SURFACE_POINT_COLORS | GI_SURFACE_CELL_COLORS);
      }
      if (look.Opacity)
      {
        surface->Color.a = 1.0f;
        Fade(*surface, static_cast<float>(*look.Opacity));
      }
    }
    this->Out.Parts.push_back(std::move(part));
  }

  vtkMapper* Mapper;
  const Drawn& Out;
  vtkCompositeDataDisplayAttributes* Looks = nullptr;
  bool Missing = false;
};
}

bool GatherComposite(vtkMapper* mapper, const Drawn& drawn)
{
  UpdateInput(mapper);
  if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    if (vtkDataObject* input = mapper->GetInputDataObject(0, 0))
    {
      Blocks(mapper, drawn).Add(input, {});
    }
  }
  return true;
}
}
