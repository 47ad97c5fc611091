// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A wall with a lightmap of known light, for tests and benchmarks.
 */
#pragma once

#include "Stage.h"

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
    this->Lamp->SetIntensity(0.001); // what is seen is the map's light
    this->Scene.Renderer->AddLight(this->Lamp);
    vtkNew<vtkLight> dark; // without any light VTK draws colours as they are
    dark->SetLightTypeToSceneLight();
    dark->SetIntensity(0.0);
    this->Scene.Renderer->AddLight(dark);
    // A wall of 4 x 4 in z = 0, seen from the front, in a colour that reflects half.
    this->Wall = this->AddWall(0.0, 4.0);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(40.0);
    camera->SetClippingRange(0.5, 50.0);
  }

  // In the plane z, facing the eye.
  vtkActor* AddWall(double z, double size)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-0.5 * size, -0.5 * size, z);
    plane->SetPoint1(0.5 * size, -0.5 * size, z);
    plane->SetPoint2(-0.5 * size, 0.5 * size, z);
    vtkActor* wall = this->Scene.Add(plane);
    wall->GetProperty()->SetColor(1.0, 1.0, 1.0);
    wall->GetProperty()->SetDiffuse(0.5);
    wall->GetProperty()->SetAmbient(0.0);
    wall->GetProperty()->SetInterpolationToFlat();
    return wall;
  }

  // The wall's map: left half and right half; from behind there is another wall of texels.
  vtkSmartPointer<vtkPolyData> Surfaces()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (const double z : { 1.0, -1.0 })
    {
      for (int i = 0; i < 4; ++i)
      {
        points->InsertNextPoint(i % 2 ? 2.0 : -2.0, i / 2 ? 2.0 : -2.0, 0.0);
        places->InsertNextTuple2(i % 2 ? 1.0 : 0.0, z > 0.0 ? 0.25 : 0.75);
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
    data->GetPointData()->SetTCoords(places);
    data->GetPointData()->SetNormals(normals);
    this->Describe(data);
    return data;
  }

  // A bake of the scene as it is.
  void Describe(vtkPolyData* surfaces)
  {
    vtkNew<vtkStringArray> scene;
    scene->SetName("scene");
    scene->InsertNextValue(vtkGILightmap::DescribeScene(this->Scene.Renderer));
    surfaces->GetFieldData()->AddArray(scene);
  }

  // The front's left half 0.6, its right half 0.2, the back 0.4, moments along x; of the lamps, where there are twice as
  // many components as without, the front 0.5, the back 0.3.
  static vtkSmartPointer<vtkImageData> Light(int channels = 3)
  {
    const int each = channels % 12 == 0 ? 12 : 3;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(8, 2, 1);
    image->AllocateScalars(VTK_FLOAT, channels);
    for (int y = 0; y < 2; ++y)
    {
      for (int x = 0; x < 8; ++x)
      {
        for (int c = 0; c < channels; ++c)
        {
          const bool lamps = c >= each && channels == 2 * each;
          const int layer = (lamps ? c - each : c) / 3;
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

  /// A lamp within the scene, with shadow maps, as frames whose cost counts have it.
  void LightAsUsers()
  {
    this->Pass->GetTechnique("shadow-maps")->EnabledOn();
    this->Lamp->PositionalOn();
    this->Lamp->SetConeAngle(180.0);
  }

  /// One matte wall fills the picture, and a little one stands before it: the least that a frame can be.
  void FillWithAWall()
  {
    this->AddWall(0.5, 1.0);
    this->Lamp->SetPosition(0.5, 0.5, 1.5);
    this->Scene.Renderer->GetActiveCamera()->SetViewAngle(35.0);
    this->Map->SetBake(this->Surfaces(), Light());
  }

  /// Six walls of a physically based look around the eye, all in the map.
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
    this->Describe(surfaces);
    this->Map->SetBake(surfaces, Light());
  }

  Stage Scene;
  vtkNew<vtkLight> Lamp;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkActor* Wall = nullptr;
  vtkGILightmap* Map = nullptr;
};
}
