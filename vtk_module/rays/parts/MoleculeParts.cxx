// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Molecules, which VTK draws as spheres and sticks by mappers that it keeps inside.
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
/// Neither the inner mappers nor what fills them have accessors; a derived class may name the members.
struct Inner : public vtkOpenGLMoleculeMapper
{
  static void Fill(vtkOpenGLMoleculeMapper* mapper) { (mapper->*(&Inner::UpdateGlyphPolyData))(); }
  static vtkMapper* Atoms(vtkOpenGLMoleculeMapper* mapper)
  {
    return mapper->*(&Inner::FastAtomMapper);
  }
  static vtkMapper* Bonds(vtkOpenGLMoleculeMapper* mapper)
  {
    return mapper->*(&Inner::FastBondMapper);
  }
};
}

bool GatherMolecule(vtkMapper* mapper, const Drawn& drawn)
{
  auto* molecule = vtkOpenGLMoleculeMapper::SafeDownCast(mapper);
  if (!molecule)
  {
    return false;
  }
  UpdateInput(mapper);
  if (molecule->GetInput())
  {
    Inner::Fill(molecule);
    if (molecule->GetRenderAtoms())
    {
      GatherSpheres(Inner::Atoms(molecule), drawn);
    }
    if (molecule->GetRenderBonds())
    {
      GatherSticks(Inner::Bonds(molecule), drawn);
    }
  }
  return true;
}
}
#else
namespace penumbra
{
bool GatherMolecule(vtkMapper*, const Drawn&)
{
  return false;
}
}
#endif
