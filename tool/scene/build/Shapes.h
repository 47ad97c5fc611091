// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Geometry given in the scene file.
#pragma once

#include "scene/model/SceneModel.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace penumbra::tool
{
/// Names of the available primitives.
std::vector<std::string> PrimitiveKinds();

vtkSmartPointer<vtkPolyData> MakePrimitive(const Primitive& shape);

/// Throws a Failure if an index is out of range or an array has the wrong length.
vtkSmartPointer<vtkPolyData> MakeMesh(const Mesh& mesh, const std::string& name);
}
