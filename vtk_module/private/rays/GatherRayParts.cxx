// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/rays/PolyDataParts.h"
#include "private/rays/RayPart.h"

#include "private/Matrices.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkDataSetMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace penumbra
{
namespace
{
struct Drawn
{
  vtkActor* Actor;
  glm::dmat4 ToWorld;
  std::vector<RayPart>& Parts;
};

bool GatherPolyData(vtkMapper* mapper, const Drawn& drawn)
{
  auto* source = static_cast<vtkPolyDataMapper*>(mapper);
  if (source->GetNumberOfInputConnections(0) > 0)
  {
    source->GetInputAlgorithm()->Update();
  }
  if (vtkPolyData* data = source->GetInput())
  {
    drawn.Parts.push_back(PolyDataPart(drawn.Actor, mapper, data, drawn.ToWorld));
  }
  return true;
}

bool GatherDataSet(vtkMapper* mapper, const Drawn& drawn)
{
  // Drawn by a mapper of polygons that it keeps and sets up as it draws.
  vtkPolyDataMapper* inner = static_cast<vtkDataSetMapper*>(mapper)->GetPolyDataMapper();
  return inner && inner->GetNumberOfInputConnections(0) > 0 && GatherPolyData(inner, drawn);
}

/// How the mappers of a class become parts; derived classes come before their bases.
struct Gatherer
{
  const char* Class;
  bool (*Gather)(vtkMapper* mapper, const Drawn& drawn);
};
constexpr std::array<Gatherer, 2> Gatherers = { {
  { "vtkDataSetMapper", GatherDataSet },
  { "vtkPolyDataMapper", GatherPolyData },
} };

bool Gather(const Drawn& drawn)
{
  vtkMapper* mapper = drawn.Actor->GetMapper();
  for (const Gatherer& gatherer : Gatherers)
  {
    if (mapper && mapper->IsA(gatherer.Class))
    {
      return gatherer.Gather(mapper, drawn);
    }
  }
  return false;
}
}

std::vector<RayPart> GatherRayParts(vtkRenderer* renderer, std::vector<vtkProp*>& left)
{
  std::vector<RayPart> parts;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      auto* actor = vtkActor::SafeDownCast(path->GetLastNode()->GetViewProp());
      if (!actor || !actor->GetVisibility() || !actor->GetMapper() ||
        actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
      {
        continue;
      }
      vtkMatrix4x4* matrix = path->GetLastNode()->GetMatrix();
      const Drawn drawn = { actor, ToMatrix(matrix ? matrix : actor->GetMatrix()), parts };
      const std::size_t before = parts.size();
      if (!Gather(drawn))
      {
        left.push_back(prop);
      }
      for (std::size_t i = before; i < parts.size(); ++i)
      {
        parts[i].Prop = prop;
      }
    }
  }
  return parts;
}
}
