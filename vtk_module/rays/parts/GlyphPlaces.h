// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a glyph mapper puts its shapes.
 */
#pragma once

#include "rays/RayScene.h"
#include "rays/parts/GatherCache.h"

#include "vtkType.h"

class vtkDataSet;
class vtkGlyph3DMapper;

namespace penumbra
{
struct GlyphPlaces
{
  std::vector<RayScene::Places> OfShape;
  bool Colored = false; ///< the places have colours of their own
  bool Partly = false;  ///< some of those are translucent

  vtkMTimeType SourceTime = 0;
};

/// Place glyphs as vtkOpenGLGlyph3DMapper does, or find that nothing changed.
const GlyphPlaces& PlaceGlyphs(GatherCache& cache, vtkGlyph3DMapper* mapper, vtkDataSet* points,
  std::size_t shapes, double opacity);
}
