// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What a file holds, as read.
#pragma once

#include "scene/model/SceneModel.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace penumbra::tool
{
/// The side from which data of a kind is looked at unless the user says otherwise.
struct DefaultView
{
  Vec3 Front = { 0, -1, 0 }; ///< from the data towards the camera
  Vec3 Up = { 0, 0, 1 };
  double Azimuth = 25;
  double Elevation = 18;
};

enum class Content
{
  Data,     ///< any VTK data object
  Molecule, ///< a vtkMolecule
  Heights,  ///< a vtkImageData of elevations in a plane
  Actors    ///< actors with their own materials
};

struct Loaded
{
  Content Kind = Content::Data;
  vtkSmartPointer<vtkDataObject> Data;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  vtkSmartPointer<vtkMatrix4x4> ToWorld; ///< null where the data is in world coordinates
  DefaultView View;
  bool PointsRepeated = false; ///< once per face, for texture coordinates that differ
};
}
