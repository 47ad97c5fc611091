// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Transformations of a glyph mapper's shapes.
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
  bool Colored = false; ///< whether the places have their own colours
  bool Partly = false;  ///< whether some of these are translucent

  vtkMTimeType SourceTime = 0;
};

/// Place glyphs as vtkOpenGLGlyph3DMapper does, or return the cached result.
const GlyphPlaces& PlaceGlyphs(GatherCache& cache, vtkGlyph3DMapper* mapper, vtkDataSet* points,
  std::size_t shapes, double opacity);
}
