// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The content of a file.
#pragma once

#include "scene/model/SceneModel.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace penumbra::tool
{
/// The view of data of some kind, unless the user sets another one.
struct DefaultView
{
  Vec3 Front = { 0, -1, 0 }; ///< from the data to the camera
  Vec3 Up = { 0, 0, 1 };
  double Azimuth = 25;
  double Elevation = 18;
};

enum class Content
{
  Data,     ///< any VTK data object
  Molecule, ///< a vtkMolecule
  Heights,  ///< a vtkImageData of elevations in a plane
  Actors    ///< actors with materials
};

struct LoadedData
{
  Content Kind = Content::Data;
  vtkSmartPointer<vtkDataObject> Data;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  vtkSmartPointer<vtkMatrix4x4> ToWorld; ///< null if the data is in world coordinates
  DefaultView View;
  bool PointsRepeated = false; ///< once per face, because their texture coordinates differ
};
}
