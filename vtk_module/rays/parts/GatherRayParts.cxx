// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/parts/Gatherers.h"

#include "base/Matrices.h"
#include "rays/parts/MapperTable.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkMapper.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace penumbra
{
std::uint64_t GatherKey(const void* a, const void* b)
{
  const auto x = reinterpret_cast<std::uintptr_t>(a);
  const auto y = reinterpret_cast<std::uintptr_t>(b);
  return x ^ (static_cast<std::uint64_t>(y) * 0x9e3779b97f4a7c15ull);
}

void UpdateInput(vtkMapper* mapper)
{
  if (!mapper->GetStatic() && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->GetInputAlgorithm()->Update();
  }
}

std::vector<glm::dvec4> ClippingPlanes(vtkMapper* mapper)
{
  std::vector<glm::dvec4> planes;
  vtkNew<vtkMatrix4x4> world;
  // VTK draws with at most this many.
  const int count = std::min(6, mapper->GetNumberOfClippingPlanes());
  for (int i = 0; i < count; ++i)
  {
    double plane[4];
    mapper->GetClippingPlaneInDataCoords(world, i, plane);
    planes.emplace_back(plane[0], plane[1], plane[2], plane[3]);
  }
  return planes;
}

std::vector<RayPart> GatherRayParts(
  vtkRenderer* renderer, std::vector<vtkProp*>& left, GatherCache& cache)
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
      // A skybox is behind everything. Its light is that of the environment.
      if (!actor || !actor->GetVisibility() || !actor->GetMapper() || actor->IsA("vtkSkybox"))
      {
        continue;
      }
      const MapperKind* kind = FindMapperKind(actor->GetMapper());
      if (!(kind && kind->Impostors) &&
        actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
      {
        continue;
      }
      vtkMatrix4x4* matrix = path->GetLastNode()->GetMatrix();
      const GatherContext context = { actor, ToMatrix(matrix ? matrix : actor->GetMatrix()), parts,
        cache };
      const std::size_t before = parts.size();
      if (!kind || !kind->Gather || !kind->Gather(actor->GetMapper(), context))
      {
        left.push_back(prop);
      }
      for (std::size_t i = before; i < parts.size(); ++i)
      {
        parts[i].Prop = prop;
      }
    }
  }
  cache.Sweep();
  return parts;
}
}
