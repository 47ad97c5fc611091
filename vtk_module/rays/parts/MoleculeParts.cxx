// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Molecules, which VTK draws as spheres and sticks by internal mappers.
#include "rays/parts/Gatherers.h"

#include "vtkMapper.h"

#if __has_include("vtkOpenGLMoleculeMapper.h") && VTK_MODULE_ENABLE_VTK_DomainsChemistryOpenGL2
#include "vtkMolecule.h"
#include "vtkOpenGLMoleculeMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"

namespace penumbra
{
namespace
{
/// Access to the internal mappers and to the method that updates their input, which are protected.
struct MoleculeMapperAccess : public vtkOpenGLMoleculeMapper
{
  static void Fill(vtkOpenGLMoleculeMapper* mapper)
  {
    (mapper->*(&MoleculeMapperAccess::UpdateGlyphPolyData))();
  }
  static vtkMapper* Atoms(vtkOpenGLMoleculeMapper* mapper)
  {
    return mapper->*(&MoleculeMapperAccess::FastAtomMapper);
  }
  static vtkMapper* Bonds(vtkOpenGLMoleculeMapper* mapper)
  {
    return mapper->*(&MoleculeMapperAccess::FastBondMapper);
  }
};
}

bool GatherMolecule(vtkMapper* mapper, const GatherContext& context)
{
  auto* molecule = vtkOpenGLMoleculeMapper::SafeDownCast(mapper);
  if (!molecule)
  {
    return false;
  }
  UpdateInput(mapper);
  if (molecule->GetInput())
  {
    MoleculeMapperAccess::Fill(molecule);
    if (molecule->GetRenderAtoms())
    {
      GatherSpheres(MoleculeMapperAccess::Atoms(molecule), context);
    }
    if (molecule->GetRenderBonds())
    {
      GatherSticks(MoleculeMapperAccess::Bonds(molecule), context);
    }
  }
  return true;
}
}
#else
namespace penumbra
{
bool GatherMolecule(vtkMapper*, const GatherContext&)
{
  return false;
}
}
#endif
