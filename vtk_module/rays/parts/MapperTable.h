// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is known of VTK's mappers, by class: how their surfaces become parts for rays, and how they draw.
 */
#pragma once

class vtkMapper;

namespace penumbra
{
struct GatherContext;

struct MapperKind
{
  const char* Class;
  /// How its surfaces become parts; nullptr: it has none.
  bool (*Gather)(vtkMapper* mapper, const GatherContext& context);
  /// It draws surfaces whatever the representation.
  bool Impostors;
  /// It fills VTK's polydata shader template and calls the hooks on every draw, so that it can be captured.
  bool Hooked;
  /// It draws the cells of its input.
  bool OfCells;
};

/// The kind of a mapper, or nullptr for one that is not known.
const MapperKind* FindMapperKind(vtkMapper* mapper);
}
