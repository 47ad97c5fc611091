// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Functions that convert mappers to parts. Each adds the parts that the mapper draws for the actor, and returns
 * whether rays see all of them.
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
struct GatherContext
{
  vtkActor* Actor;
  glm::dmat4 ToWorld;
  std::vector<RayPart>& Parts;
  GatherCache& Cache;
};

bool GatherPolyData(vtkMapper* mapper, const GatherContext& context);
bool GatherDataSet(vtkMapper* mapper, const GatherContext& context);
bool GatherComposite(vtkMapper* mapper, const GatherContext& context);
bool GatherGlyphs(vtkMapper* mapper, const GatherContext& context);
bool GatherSpheres(vtkMapper* mapper, const GatherContext& context);
bool GatherSticks(vtkMapper* mapper, const GatherContext& context);
bool GatherMolecule(vtkMapper* mapper, const GatherContext& context);

/// Key of data that is computed from two objects.
std::uint64_t GatherKey(const void* a, const void* b = nullptr);

/// Bring a mapper's input up to date, as drawing would.
void UpdateInput(vtkMapper* mapper);

/// The mapper's clipping planes in world coordinates. Their negative side is not drawn.
std::vector<glm::dvec4> ClippingPlanes(vtkMapper* mapper);
}
