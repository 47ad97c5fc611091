// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays see spheres, sticks and molecules as VTK's impostors show them.
#include "Agreement.h"

#include "vtkCellArray.h"
#include "vtkMolecule.h"
#include "vtkMoleculeMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlane.h"

using namespace penumbra_test;

namespace
{
// A grid of points, each with a value, a radius, a direction and the size of a stick.
vtkSmartPointer<vtkPolyData> Points()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkFloatArray> radii;
  vtkNew<vtkFloatArray> directions;
  vtkNew<vtkFloatArray> sizes;
  values->SetName("value");
  radii->SetName("radius");
  directions->SetName("direction");
  directions->SetNumberOfComponents(3);
  sizes->SetName("size");
  sizes->SetNumberOfComponents(3);
  for (int i = 0; i < 12; ++i)
  {
    const vtkIdType id = points->InsertNextPoint(i % 4, i / 4, 0.0);
    vertices->InsertNextCell(1, &id); // data without cells has no bounds for the camera
    values->InsertNextValue(i / 12.0);
    radii->InsertNextValue(0.25f + 0.05f * (i % 4));
    directions->InsertNextTuple3(std::cos(0.5 * i), std::sin(0.5 * i), 0.6);
    sizes->InsertNextTuple3(0.6 + 0.02 * i, 0.2, 0.0);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->SetScalars(values);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->AddArray(directions);
  data->GetPointData()->AddArray(sizes);
  return data;
}

vtkActor* AddSpheres(Stage& stage, bool scalars, bool sizes)
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(Points());
  mapper->SetScalarVisibility(scalars);
  mapper->SetRadius(0.4f);
  if (sizes)
  {
    mapper->SetScaleArray("radius");
  }
  vtkActor* actor = stage.Add(mapper);
  actor->GetProperty()->SetSpecular(0.3);
  return actor;
}

vtkActor* AddSticks(Stage& stage)
{
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(Points());
  mapper->SetOrientationArray("direction");
  mapper->SetScaleArray("size");
  return stage.Add(mapper);
}

void AddMolecule(Stage& stage, void (vtkMoleculeMapper::*settings)())
{
  vtkNew<vtkMolecule> molecule;
  vtkAtom carbon = molecule->AppendAtom(6, 0.0, 0.0, 0.0);
  const double others[4][3] = { { 0.9, 0.9, 0.9 }, { -0.9, -0.9, 0.9 }, { -0.9, 0.9, -0.9 },
    { 0.9, -0.9, -0.9 } };
  const unsigned short elements[4] = { 1, 7, 8, 16 };
  for (int i = 0; i < 4; ++i)
  {
    molecule->AppendBond(carbon,
      molecule->AppendAtom(elements[i], others[i][0], others[i][1], others[i][2]),
      static_cast<unsigned short>(1 + i % 3));
  }
  vtkNew<vtkMoleculeMapper> mapper;
  mapper->SetInputData(molecule);
  (mapper->*settings)();
  stage.Add(mapper);
}
}

TEST(PathsImpostors, SpheresOfOneRadius)
{
  Stage stage;
  AddSpheres(stage, false, false);
  LightFromCamera(stage);
  ExpectAgreement(stage, "spheres");
}

TEST(PathsImpostors, SpheresOfManySizesAndColours)
{
  Stage stage;
  AddSpheres(stage, true, true);
  LightFromCamera(stage);
  ExpectAgreement(stage, "spheres-sizes");
}

TEST(PathsImpostors, Sticks)
{
  Stage stage;
  AddSticks(stage);
  LightFromCamera(stage);
  ExpectAgreement(stage, "sticks");
}

TEST(PathsImpostors, RotatedAndScaledActors)
{
  Stage stage;
  vtkActor* rotated = AddSpheres(stage, true, true);
  rotated->SetPosition(0.5, -3.5, 0.2);
  rotated->RotateZ(10.0);
  // VTK scales the positions of impostors, not their sizes.
  AddSpheres(stage, true, true)->SetScale(1.3, 1.1, 1.0);
  vtkActor* sticks = AddSticks(stage);
  sticks->RotateX(30.0);
  sticks->SetPosition(0.0, 3.5, 0.0);
  LightFromCamera(stage);
  ExpectAgreement(stage, "impostors-moved");
}

TEST(PathsImpostors, AreClippedByTheirCentres)
{
  Stage stage;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1.6, 0.0, 0.0);
  plane->SetNormal(1.0, 0.1, 0.0);
  AddSpheres(stage, true, true)->GetMapper()->AddClippingPlane(plane);
  LightFromCamera(stage);
  ExpectAgreement(stage, "spheres-clipped");
}

TEST(PathsImpostors, MoleculesOfBallsAndSticks)
{
  Stage stage;
  AddMolecule(stage, &vtkMoleculeMapper::UseBallAndStickSettings);
  LightFromCamera(stage);
  stage.Renderer->GetActiveCamera()->Zoom(3.0);
  ExpectAgreement(stage, "molecule");
}

TEST(PathsImpostors, MoleculesOfSticksAndOfSpheres)
{
  for (auto settings : { &vtkMoleculeMapper::UseLiquoriceStickSettings,
         &vtkMoleculeMapper::UseVDWSpheresSettings, &vtkMoleculeMapper::UseFastSettings })
  {
    Stage stage;
    AddMolecule(stage, settings);
    LightFromCamera(stage);
    stage.Renderer->GetActiveCamera()->Zoom(3.0);
    ExpectAgreement(stage, "molecule-settings");
  }
}
