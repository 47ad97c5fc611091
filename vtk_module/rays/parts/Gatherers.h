// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How mappers of one kind become parts. Each adds what the mapper draws for the actor, and says
 * whether rays see all of it.
 */
#pragma once

#include "rays/RayPart.h"
#include "rays/parts/GatherCache.h"

#include <cstdint>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkProperty;

namespace penumbra
{
struct Drawn
{
  vtkActor* Actor;
  glm::dmat4 ToWorld;
  std::vector<RayPart>& Parts;
  GatherCache& Cache;
};

bool GatherPolyData(vtkMapper* mapper, const Drawn& drawn);
bool GatherDataSet(vtkMapper* mapper, const Drawn& drawn);
bool GatherComposite(vtkMapper* mapper, const Drawn& drawn);
bool GatherGlyphs(vtkMapper* mapper, const Drawn& drawn);
bool GatherSpheres(vtkMapper* mapper, const Drawn& drawn);
bool GatherSticks(vtkMapper* mapper, const Drawn& drawn);
bool GatherMolecule(vtkMapper* mapper, const Drawn& drawn);

/// A number for what is made of two objects.
std::uint64_t GatherKey(const void* a, const void* b = nullptr);

/// Bring a mapper's input up to date, as drawing it would.
void UpdateInput(vtkMapper* mapper);

/// The mapper's clipping planes in the world: what lies on their negative side is not drawn.
std::vector<glm::dvec4> ClippingPlanes(vtkMapper* mapper);
}
