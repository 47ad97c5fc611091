// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A wall with a lightmap of known light, for tests and benchmarks.
 */
#pragma once

#include "SceneParts.h"

#include "vtkGILightmap.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>

namespace penumbra_test
{
struct LightmapScene
{
  LightmapScene()
  {
    this->Scene.Window->SetSize(64, 64);
    this->Scene.Renderer->AutomaticLightCreationOff();
    this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Map = vtkGILightmap::SafeDownCast(this->Pass->GetTechnique("lightmap"));
    this->Map->EnabledOn();
    this->Lamp->SetLightTypeToSceneLight();
    this->Lamp->SetPosition(0.0, 0.0, 5.0);
    this->Lamp->SetIntensity(0.001); // nearly all light comes from the map
    this->Scene.Renderer->AddLight(this->Lamp);
    vtkNew<vtkLight> dark; // without any light VTK draws unlit colours
    dark->SetLightTypeToSceneLight();
    dark->SetIntensity(0.0);
    this->Scene.Renderer->AddLight(dark);
    // A wall of 4 x 4 at z = 0, seen from the front, with a reflectance of one half.
    this->Wall = this->AddWall(0.0, 4.0);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(40.0);
    camera->SetClippingRange(0.5, 50.0);
  }

  /// Add a square wall in a plane of constant z that faces the camera.
  vtkActor* AddWall(double z, double size)
  {
    const double half = 0.5 * size;
    vtkActor* wall = AddFloor(this->Scene, -half, half, -half, half, z);
    wall->GetProperty()->SetColor(1.0, 1.0, 1.0);
    wall->GetProperty()->SetDiffuse(0.5);
    wall->GetProperty()->SetAmbient(0.0);
    wall->GetProperty()->SetInterpolationToFlat();
    return wall;
  }

  /// Surfaces of the bake: the wall's front has the lower row of texels, its back the upper row.
  vtkSmartPointer<vtkPolyData> Surfaces()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(2);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (const double z : { 1.0, -1.0 })
    {
      for (int i = 0; i < 4; ++i)
      {
        points->InsertNextPoint(i % 2 ? 2.0 : -2.0, i / 2 ? 2.0 : -2.0, 0.0);
        coordinates->InsertNextTuple2(i % 2 ? 1.0 : 0.0, z > 0.0 ? 0.25 : 0.75);
        normals->InsertNextTuple3(0.0, 0.0, z);
      }
    }
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[4][3] = { { 0, 1, 3 }, { 0, 3, 2 }, { 5, 4, 7 }, { 4, 6, 7 } };
    for (const auto& triangle : corners)
    {
      cells->InsertNextCell(3, triangle);
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetTCoords(coordinates);
    data->GetPointData()->SetNormals(normals);
    this->StoreScene(data);
    return data;
  }

  /// Mark surfaces as baked from the scene in its present state.
  void StoreScene(vtkPolyData* surfaces)
  {
    vtkNew<vtkStringArray> scene;
    scene->SetName("scene");
    scene->InsertNextValue(vtkGILightmap::DescribeScene(this->Scene.Renderer));
    surfaces->GetFieldData()->AddArray(scene);
  }

  /// Light of the map: 0.6 on the left half of the front, 0.2 on the right half, 0.4 on the back. Directional maps have
  /// moments along x. With twice as many components the map also has light of lamps: 0.5 on the front, 0.3 on the back.
  static vtkSmartPointer<vtkImageData> Light(int channels = 3)
  {
    const int perLight = channels % 12 == 0 ? 12 : 3;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(8, 2, 1);
    image->AllocateScalars(VTK_FLOAT, channels);
    for (int y = 0; y < 2; ++y)
    {
      for (int x = 0; x < 8; ++x)
      {
        for (int c = 0; c < channels; ++c)
        {
          const bool lamps = c >= perLight && channels == 2 * perLight;
          const int layer = (lamps ? c - perLight : c) / 3;
          const double front = lamps ? 0.5 : x < 4 ? 0.6 : 0.2;
          const double value = y == 0 ? front : lamps ? 0.3 : 0.4;
          const double moment = layer == 1 ? 0.1 : 0.0; // along x
          image->SetScalarComponentFromDouble(
            x, y, 0, c, channels == 4 || layer == 0 ? value : moment);
        }
      }
    }
    return image;
  }

  /// Put the lamp into the scene and give it shadow maps, as in the frames whose cost is measured.
  void UseShadowedLamp()
  {
    this->Pass->GetTechnique("shadow-maps")->EnabledOn();
    ShineAllRound(this->Lamp);
  }

  /// Fill the picture with one matte wall and put a small one before it: the cheapest frame there is.
  void FillWithAWall()
  {
    this->AddWall(0.5, 1.0);
    this->Lamp->SetPosition(0.5, 0.5, 1.5);
    this->Scene.Renderer->GetActiveCamera()->SetViewAngle(35.0);
    this->Map->SetBake(this->Surfaces(), Light());
  }

  /// Surround the camera with six walls of a physically based material, all of them in the map.
  void MoveIntoARoom()
  {
    this->Scene.Renderer->RemoveActor(this->Wall);
    vtkNew<vtkAppendPolyData> all;
    for (int side = 0; side < 6; ++side)
    {
      const int axis = side / 2;
      const double at = side % 2 ? 2.0 : -2.0;
      double corners[3][3];
      for (int i = 0; i < 3; ++i)
      {
        corners[i][axis] = at;
        corners[i][(axis + 1) % 3] = i == (side % 2 ? 2 : 1) ? 2.0 : -2.0;
        corners[i][(axis + 2) % 3] = i == (side % 2 ? 1 : 2) ? 2.0 : -2.0;
      }
      vtkNew<vtkPlaneSource> wall;
      wall->SetOrigin(corners[0]);
      wall->SetPoint1(corners[1]);
      wall->SetPoint2(corners[2]);
      this->Scene.Add(wall)->GetProperty()->SetInterpolationToPBR();
      vtkNew<vtkTriangleFilter> triangles;
      triangles->SetInputConnection(wall->GetOutputPort());
      all->AddInputConnection(triangles->GetOutputPort());
    }
    all->Update();
    this->Lamp->SetPosition(0.0, 0.0, 1.5);
    this->Scene.Renderer->GetActiveCamera()->SetPosition(-1.5, -1.5, -1.0);
    vtkPolyData* surfaces = all->GetOutput();
    this->StoreScene(surfaces);
    this->Map->SetBake(surfaces, Light());
  }

  Stage Scene;
  vtkNew<vtkLight> Lamp;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkActor* Wall = nullptr;
  vtkGILightmap* Map = nullptr;
};
}
