// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Geometry described in the scene itself.
#pragma once

#include "scene/model/SceneModel.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace penumbra::tool
{
/// The kinds of primitives there are.
const std::vector<std::string>& PrimitiveKinds();

vtkSmartPointer<vtkPolyData> MakePrimitive(const Primitive& shape);

/// Throws a Failure where an index is out of range or an array has the wrong length.
vtkSmartPointer<vtkPolyData> MakeMesh(const Mesh& mesh, const std::string& name);
}
