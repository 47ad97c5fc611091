// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/parts/Gatherers.h"

#include "base/Matrices.h"

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
namespace
{
/// Function that converts mappers of a class to parts. Derived classes come before their bases.
struct Gatherer
{
  const char* Class;
  bool (*Gather)(vtkMapper* mapper, const GatherContext& context);
  bool Impostors; ///< drawn as surfaces regardless of the representation
};
// Mappers are identified by name, as their inheritance differs between VTK versions.
constexpr std::array<Gatherer, 9> Gatherers = { {
  { "vtkPointGaussianMapper", nullptr, false }, // soft splats have no surface
  { "vtkMoleculeMapper", GatherMolecule, true },
  { "vtkOpenGLSphereMapper", GatherSpheres, true },
  { "vtkOpenGLStickMapper", GatherSticks, true },
  { "vtkGlyph3DMapper", GatherGlyphs, false },
  { "vtkCompositePolyDataMapper2", GatherComposite, false },
  { "vtkCompositePolyDataMapper", GatherComposite, false },
  { "vtkDataSetMapper", GatherDataSet, false },
  { "vtkPolyDataMapper", GatherPolyData, false },
} };

const Gatherer* Find(vtkMapper* mapper)
{
  const auto found = std::find_if(Gatherers.begin(), Gatherers.end(),
    [mapper](const Gatherer& gatherer) { return mapper->IsA(gatherer.Class) != 0; });
  return found == Gatherers.end() ? nullptr : &*found;
}
}

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
      const Gatherer* gatherer = Find(actor->GetMapper());
      if (!(gatherer && gatherer->Impostors) &&
        actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
      {
        continue;
      }
      vtkMatrix4x4* matrix = path->GetLastNode()->GetMatrix();
      const GatherContext context = { actor, ToMatrix(matrix ? matrix : actor->GetMatrix()), parts,
        cache };
      const std::size_t before = parts.size();
      if (!gatherer || !gatherer->Gather || !gatherer->Gather(actor->GetMapper(), context))
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
