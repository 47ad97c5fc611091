// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Molecules as balls and sticks.
#pragma once

#include "scene/model/SceneModel.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkMolecule;
class vtkOpenGLSphereMapper;

namespace penumbra::tool
{
/// Atoms as points with the arrays "radius" (van der Waals, in Angstrom) and "element color".
vtkSmartPointer<vtkPolyData> MakeAtoms(vtkMolecule* molecule);

/// A mapper that draws a ball at each point, with the radius in an array.
vtkSmartPointer<vtkOpenGLSphereMapper> MakeBallMapper(vtkPolyData* points, const char* radiusArray);

/// Balls joined by sticks, or sticks only.
vtkSmartPointer<vtkActor> MakeStickModel(vtkMolecule* molecule, MoleculeStyle style);
}
