// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers that draw a shape at each point: one part per shape, with an instance for each point that shows it.
#include "rays/parts/GlyphPlaces.h"
#include "rays/parts/PolyDataParts.h"
#include "rays/parts/SurfaceMaterial.h"

#include "base/Matrices.h"

#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

namespace penumbra
{
namespace
{
/// Shapes from which the points select. An entry can be a tree of shapes.
std::vector<vtkDataObject*> Shapes(vtkGlyph3DMapper* mapper)
{
  std::vector<vtkDataObject*> shapes;
  if (mapper->GetUseSourceTableTree())
  {
    if (vtkDataObjectTree* table = mapper->GetSourceTableTree())
    {
      auto iterator = vtk::TakeSmartPointer(table->NewTreeIterator());
      iterator->VisitOnlyLeavesOff();
      iterator->TraverseSubTreeOff();
      for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      {
        shapes.push_back(iterator->GetCurrentDataObject());
      }
    }
    return shapes;
  }
  for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
  {
    shapes.push_back(mapper->GetSource(i));
  }
  return shapes;
}

void ForEachLeaf(vtkDataObject* object, const std::function<void(vtkDataObject*)>& visit)
{
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto iterator = vtk::TakeSmartPointer(tree->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      visit(iterator->GetCurrentDataObject());
    }
  }
  else if (object)
  {
    visit(object);
  }
}

void AddShape(vtkPolyData* shape, vtkGlyph3DMapper* mapper, const GatherContext& context,
  const GlyphPlaces& glyphs, const RayScene::Places& places, const glm::dvec3& color)
{
  // VTK ignores the scalars of the shape.
  RayPart part = PolyDataPart(context, mapper, shape, ScalarColors());
  part.AttributeKey = GatherKey(shape);
  part.Places = places;
  vtkProperty* property = context.Actor->GetProperty();
  // VTK applies the opacity a second time, rounded to a byte, with the glyphs' colours.
  const double opacity = std::floor(property->GetOpacity() * 255.0 + 0.5) / 255.0;
  for (shared::RaySurface* surface : { &part.Surface, &part.Back })
  {
    if (glyphs.Colored)
    {
      surface->Where.z |= GI_SURFACE_PLACE_COLORS | (glyphs.Partly ? GI_SURFACE_PARTLY : 0);
    }
    else
    {
      Recolor(*surface, property, glm::vec3(glm::floor(color * 255.0 + 0.5) / 255.0));
      Fade(*surface, static_cast<float>(opacity));
    }
  }
  context.Parts.push_back(std::move(part));
}
}

bool GatherGlyphs(vtkMapper* mapper, const GatherContext& context)
{
  auto* source = static_cast<vtkGlyph3DMapper*>(mapper);
  if (source->GetNumberOfInputConnections(0) == 0)
  {
    return true;
  }
  if (!source->GetStatic())
  {
    source->Update(); // points and shapes
  }
  const std::vector<vtkDataObject*> shapes = Shapes(source);
  vtkCompositeDataDisplayAttributes* attributes = source->GetBlockAttributes();
  ForEachLeaf(source->GetInputDataObject(0, 0), [&](vtkDataObject* leaf) {
    auto* points = vtkDataSet::SafeDownCast(leaf);
    const bool hidden =
      attributes && attributes->HasBlockVisibility(leaf) && !attributes->GetBlockVisibility(leaf);
    if (!points || hidden || points->GetNumberOfPoints() == 0)
    {
      return;
    }
    double color[3];
    context.Actor->GetProperty()->GetColor(color);
    if (attributes && attributes->HasBlockColor(leaf))
    {
      attributes->GetBlockColor(leaf, color);
    }
    const GlyphPlaces& glyphs = PlaceGlyphs(
      context.Cache, source, points, shapes.size(), context.Actor->GetProperty()->GetOpacity());
    for (std::size_t i = 0; i < shapes.size() && i < glyphs.OfShape.size(); ++i)
    {
      if (glyphs.OfShape[i]->empty())
      {
        continue;
      }
      ForEachLeaf(shapes[i], [&](vtkDataObject* object) {
        auto* shape = vtkPolyData::SafeDownCast(object);
        if (shape && shape->GetNumberOfPoints() > 0)
        {
          AddShape(shape, source, context, glyphs, glyphs.OfShape[i], ToVec3(color));
        }
      });
    }
  });
  return true;
}
}
