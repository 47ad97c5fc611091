// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The usual views of data, and which of them suits polygons whose format does not say what they are.
#pragma once

#include "scene/model/LoadedData.h"

#include <vtkPolyData.h>

namespace penumbra::tool
{
/// Modelled shapes stand along y and face z.
inline const DefaultView ModelView = { { 0, 0, 1 }, { 0, 1, 0 }, 25, 12 };
/// Simulations and volumes stand along z; x points right.
inline const DefaultView SimulationView = { { 0, -1, 0 }, { 0, 0, 1 }, 30, 20 };
/// Right, anterior, superior coordinates: a view of the face.
inline const DefaultView PatientView = { { 0, 1, 0 }, { 0, 0, 1 }, 30, 2 };
/// The camera looks north.
inline const DefaultView LandView = { { 0, -1, 0 }, { 0, 0, 1 }, -20, 38 };

struct Standing
{
  DefaultView View;
  const char* Reason = nullptr; ///< why the view differs from the format's usual one
};

/// The view of polygons. Ground that a surface covers once is a terrain along z or y. Shapes in VTK's format with arrays of
/// results come from a simulation.
Standing FindStanding(vtkPolyData* polygons, const DefaultView& usual, bool vtkFormat);
}
