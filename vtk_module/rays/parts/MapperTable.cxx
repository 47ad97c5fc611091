// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/parts/MapperTable.h"

#include "rays/parts/Gatherers.h"

#include "vtkMapper.h"

namespace penumbra
{
namespace
{
// Mappers are told apart by name, as versions of VTK derive them from one another differently. Derived classes come
// before their bases.
constexpr MapperKind Kinds[] = {
  // class, gather, impostors, hooked, of cells
  { "vtkPointGaussianMapper", nullptr, false, false, true }, // soft splats: no surface, a template of their own
  { "vtkOpenGLLowMemoryPolyDataMapper", GatherPolyData, false, false, true }, // never calls SetShaderParameters
  { "vtkSurfaceLICMapper", GatherPolyData, false, false, true },              // writes outputs of its own
  { "vtkMoleculeMapper", GatherMolecule, true, true, false },
  { "vtkOpenGLSphereMapper", GatherSpheres, true, true, true },
  { "vtkOpenGLStickMapper", GatherSticks, true, true, true },
  { "vtkGlyph3DMapper", GatherGlyphs, false, true, false },
  { "vtkCompositePolyDataMapper2", GatherComposite, false, true, true },
  { "vtkCompositePolyDataMapper", GatherComposite, false, true, true },
  { "vtkDataSetMapper", GatherDataSet, false, true, false },
  { "vtkPolyDataMapper", GatherPolyData, false, true, true },
};
}

const MapperKind* FindMapperKind(vtkMapper* mapper)
{
  const auto found = std::find_if(std::begin(Kinds), std::end(Kinds),
    [mapper](const MapperKind& kind) { return mapper->IsA(kind.Class) != 0; });
  return found == std::end(Kinds) ? nullptr : found;
}
}
