// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A wall with a lightmap of known light.
 */
#pragma once

#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGILightmap.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra_test
{
class LightmapTechnique : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(64, 64);
    this->Scene.Renderer->AutomaticLightCreationOff();
    this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Pass->KeepRadianceOn();
    this->Map = vtkGILightmap::SafeDownCast(this->Pass->GetTechnique("lightmap"));
    ASSERT_NE(this->Map, nullptr);
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
  void TearDown() override
  {
    for (const std::string& message : TakeMessages())
    {
      ADD_FAILURE() << message;
    }
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

  void Bake(int channels = 3)
  {
    ASSERT_TRUE(this->Map->SetBake(this->Surfaces(), Light(channels)));
  }

  // The next frame's radiance at a pixel, 0 to 1 across the picture.
  double At(double x, double y, bool draw = true)
  {
    if (draw)
    {
      this->Scene.Window->Render();
    }
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, image));
    const int* size = image->GetDimensions();
    return image->GetScalarComponentAsDouble(int(x * size[0]), int(y * size[1]), 0, 0);
  }
  std::string Notes() { return this->Pass->GetNotes(); }

  // The wall with normals that lean to x, by an angle of this sine.
  void LeanNormals(double sine)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-2.0, -2.0, 0.0);
    source->SetPoint1(2.0, -2.0, 0.0);
    source->SetPoint2(-2.0, 2.0, 0.0);
    source->Update();
    vtkNew<vtkPolyData> leaning;
    leaning->DeepCopy(source->GetOutput());
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (int i = 0; i < 4; ++i)
    {
      normals->InsertNextTuple3(sine, 0.0, std::sqrt(1.0 - sine * sine));
    }
    leaning->GetPointData()->SetNormals(normals);
    vtkPolyDataMapper::SafeDownCast(this->Wall->GetMapper())->SetInputData(leaning);
    this->Wall->GetProperty()->SetInterpolationToPhong();
  }

  // The next frame has no baked light and says why.
  void ExpectStale(const char* why)
  {
    const double left = this->At(0.2, 0.5);
    EXPECT_LT(left, 0.01) << why;
    EXPECT_NE(this->Notes().find(why), std::string::npos) << this->Notes();
    EXPECT_NE(this->Map->GetMismatch(this->Scene.Renderer).find(why), std::string::npos);
  }
  void ExpectFits()
  {
    EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002);
    EXPECT_EQ(this->Notes(), "");
    EXPECT_EQ(this->Map->GetMismatch(this->Scene.Renderer), "");
  }

  Stage Scene;
  vtkNew<vtkLight> Lamp;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkActor* Wall = nullptr;
  vtkGILightmap* Map = nullptr;
};
}
