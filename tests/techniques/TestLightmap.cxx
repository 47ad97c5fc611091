// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked light on surfaces: where it shows and where not, and that it never outlives its scene.
 */
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
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ctime>

using namespace penumbra_test;

namespace
{
using Rgb = std::array<double, 3>;

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
    vtkNew<vtkStringArray> scene;
    scene->SetName("scene");
    scene->InsertNextValue(vtkGILightmap::DescribeScene(this->Scene.Renderer));
    data->GetFieldData()->AddArray(scene);
    return data;
  }

  static vtkSmartPointer<vtkImageData> Light(int channels = 3)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(8, 2, 1);
    image->AllocateScalars(VTK_FLOAT, channels);
    for (int y = 0; y < 2; ++y)
    {
      for (int x = 0; x < 8; ++x)
      {
        for (int c = 0; c < channels; ++c)
        {
          const double front = x < 4 ? 0.6 : 0.2;
          const double moment = (c - 3) / 3 == 0 ? 0.1 : 0.0; // along x
          image->SetScalarComponentFromDouble(x, y, 0, c, c >= 3 ? moment : y == 0 ? front : 0.4);
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

TEST_F(LightmapTechnique, LightLiesWhereItWasBaked)
{
  this->Bake();
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * 0.6, 0.002);
  EXPECT_NEAR(this->At(0.8, 0.5, false), 0.5 * 0.2, 0.002);
  // From behind, that of the back.
  this->Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -5.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * 0.4, 0.002);
  this->Map->SetIntensity(2.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.4, 0.002);
}

TEST_F(LightmapTechnique, SlantedAndFarViewsLoseNothing)
{
  this->Bake();
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  // In a picture of the wall alone every pixel is lit, in whatever projection and from wherever.
  const double places[][3] = { { 0.3, 4.5, 0.4 }, { 1.9, 1.0, 0.05 }, { 0.0, 0.0, 900.0 } };
  for (const auto& place : places)
  {
    for (const bool parallel : { false, true })
    {
      camera->SetParallelProjection(parallel);
      camera->SetPosition(place);
      camera->SetViewUp(1.0, 0.0, 0.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetViewAngle(place[2] > 100.0 ? 0.2 : 40.0);
      camera->SetParallelScale(1.5);
      camera->SetClippingRange(place[2] > 100.0 ? 890.0 : 0.02, place[2] > 100.0 ? 910.0 : 20.0);
      this->Scene.Window->Render();
      vtkNew<vtkImageData> image;
      ASSERT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, image));
      int shown = 0, dark = 0;
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const bool surface = image->GetPointData()->GetScalars()->GetComponent(i, 3) > 0.5;
        const bool lit = image->GetPointData()->GetScalars()->GetComponent(i, 0) > 0.09;
        shown += surface ? 1 : 0;
        dark += surface && !lit ? 1 : 0;
      }
      EXPECT_GT(shown, 100);
      EXPECT_EQ(dark, 0) << place[2] << (parallel ? ", parallel" : "") << " of " << shown;
    }
  }
}

TEST_F(LightmapTechnique, WhatStandsBeforeAWallIsNotLitAsTheWall)
{
  this->Bake();
  this->ExpectFits();
  vtkActor* mover = this->AddWall(0.003, 1.0);
  mover->SetPosition(-1.2, 0.0, 0.0);
  EXPECT_LT(this->At(0.2, 0.5), 0.01) << "right before the wall";
  EXPECT_EQ(this->Notes(), "") << "what the bake does not know may come";
  EXPECT_NEAR(this->At(0.8, 0.5, false), 0.1, 0.002);
  mover->SetPosition(1.2, 0.0, 0.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002);
  EXPECT_LT(this->At(0.8, 0.5, false), 0.01);
}

TEST_F(LightmapTechnique, AMovedWallIsReportedAtOnce)
{
  this->Bake();
  this->ExpectFits();
  this->Wall->SetPosition(0.0, 0.0, 0.01);
  this->ExpectStale("object 1 moved");
  this->Wall->SetPosition(0.0, 0.0, 0.0);
  this->ExpectFits();
  this->Wall->VisibilityOff();
  this->AddWall(0.0, 3.9);
  this->ExpectStale("object 1 ");
}

TEST_F(LightmapTechnique, AnotherColourIsReportedAtOnce)
{
  this->Bake();
  this->ExpectFits();
  this->Wall->GetProperty()->SetColor(1.0, 0.99, 1.0);
  this->ExpectStale("object 1 changed its look");
  this->Wall->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->ExpectFits();
}

TEST_F(LightmapTechnique, LampsAreReportedAtOnce)
{
  this->Bake();
  this->ExpectFits();
  this->Lamp->SetPosition(0.1, 0.0, 5.0);
  this->ExpectStale("light 1 moved");
  this->Lamp->SetPosition(0.0, 0.0, 5.0);
  this->Lamp->SetDiffuseColor(1.0, 0.9, 1.0);
  this->ExpectStale("light 1 changed its colour");
  this->Lamp->SetDiffuseColor(1.0, 1.0, 1.0);
  this->Lamp->SwitchOff();
  this->ExpectStale("light 1 went out");
  this->Lamp->SwitchOn();
  vtkNew<vtkLight> other;
  other->SetLightTypeToSceneLight();
  other->SetIntensity(0.002);
  this->Scene.Renderer->AddLight(other);
  this->ExpectStale("light 3 came");
  this->Scene.Renderer->RemoveLight(other);
  this->ExpectFits();
}

// What changes while the technique is off is seen when it comes on again.
TEST_F(LightmapTechnique, ChangesUnseenAreFound)
{
  this->Bake();
  this->ExpectFits();
  this->Map->EnabledOff();
  this->Scene.Window->Render();
  this->Wall->SetPosition(0.0, 0.0, 0.5);
  this->Scene.Window->Render();
  this->Scene.Window->Render();
  this->Map->EnabledOn();
  this->ExpectStale("object 1 moved");
}

TEST_F(LightmapTechnique, MovingTheCameraChangesNothing)
{
  this->Bake();
  this->ExpectFits();
  this->Scene.Renderer->GetActiveCamera()->Azimuth(5.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002);
  EXPECT_EQ(this->Notes(), "");
}

TEST_F(LightmapTechnique, StaleMapsLeaveTheLightToProbes)
{
  this->Bake();
  this->Pass->GetTechnique("ddgi")->SetParameter("probes", 64);
  this->Pass->GetTechnique("ddgi")->SetParameter("rays", 32);
  this->Pass->GetTechnique("ddgi")->EnabledOn();
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002) << "the map comes first";
  this->Lamp->SetIntensity(3.0);
  this->AddWall(1.0, 20.0)->SetPosition(12.0, 0.0, 0.0);
  for (int i = 0; i < 4; ++i)
  {
    this->Scene.Window->Render();
  }
  const double probes = this->At(0.2, 0.5);
  this->Pass->GetTechnique("ddgi")->EnabledOff();
  EXPECT_GT(std::abs(probes - this->At(0.2, 0.5)), 1e-4);
}

TEST_F(LightmapTechnique, DirectionalMapsFollowBentNormals)
{
  this->Bake(12);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002) << "as baked where the normal is as baked";
  // The same wall with normals that lean to x by 30 degrees.
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
    normals->InsertNextTuple3(0.5, 0.0, std::sqrt(0.75));
  }
  leaning->GetPointData()->SetNormals(normals);
  vtkPolyDataMapper::SafeDownCast(this->Wall->GetMapper())->SetInputData(leaning);
  this->Wall->GetProperty()->SetInterpolationToPhong();
  this->Bake(12);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * (0.6 + 0.1 * 0.5), 0.002);
}

TEST_F(LightmapTechnique, AMultisampledWindowShowsIt)
{
  this->Scene.Window->SetMultiSamples(8);
  this->Pass->KeepRadianceOff();
  this->Bake();
  this->Lamp->SetIntensity(0.001);
  const Picture picture = Shoot(this->Scene.Window);
  EXPECT_NEAR(picture.Grey(13, 32), 0.3 * 255.0, 2.0);
}

// By processor time, all threads together: other programs' work does not count.
TEST_F(LightmapTechnique, AFetchCostsLittleBesideDirectLight)
{
  this->Scene.Window->SetSize(1280, 720);
  this->Pass->KeepRadianceOff();
  this->Pass->GetTechnique("shadow-maps")->EnabledOn();
  this->AddWall(0.5, 1.0);
  this->Bake();
  this->Scene.Renderer->GetActiveCamera()->SetViewAngle(35.0);
  std::array<std::vector<double>, 2> times;
  for (int i = 0; i < 26; ++i)
  {
    this->Map->SetEnabled(i % 2 == 0);
    this->Scene.Renderer->GetActiveCamera()->Azimuth(0.01); // nothing is averaged
    const std::clock_t start = std::clock();
    this->Scene.Window->Render();
    this->Scene.Window->WaitForCompletion();
    times[i % 2].push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  for (auto& some : times)
  {
    some.erase(some.begin());
    std::sort(some.begin(), some.end());
  }
  const double with = times[0][times[0].size() / 2], without = times[1][times[1].size() / 2];
  std::printf("a frame of 1280 x 720: %.1f ms of processor time, with the lightmap %.1f ms: %.3f\n",
    1e3 * without, 1e3 * with, with / without);
}

TEST_F(LightmapTechnique, WhatIsNoMapIsRefused)
{
  EXPECT_FALSE(this->Map->HasBake());
  this->Scene.Window->Render();
  EXPECT_NE(this->Notes().find("without a bake"), std::string::npos);
  this->Bake();
  const auto refused = [this](vtkPolyData* surfaces, vtkImageData* light, const char* why) {
    EXPECT_FALSE(this->Map->SetBake(surfaces, light));
    const auto messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find(why), std::string::npos) << messages[0];
  };
  auto surfaces = this->Surfaces();
  refused(surfaces, nullptr, "both surfaces and light");
  refused(surfaces, Light(4), "3 or 12 components");
  surfaces->GetFieldData()->RemoveArray("scene");
  refused(surfaces, Light(), "which scene");
  surfaces = this->Surfaces();
  surfaces->GetPointData()->SetTCoords(nullptr);
  refused(surfaces, Light(), "texture coordinates");
  surfaces = this->Surfaces();
  vtkNew<vtkCellArray> cells;
  const vtkIdType beyond[] = { 0, 1, 99 };
  cells->InsertNextCell(3, beyond);
  surfaces->SetPolys(cells);
  refused(surfaces, Light(), "not triangles of its points");
  this->ExpectFits();
  EXPECT_TRUE(this->Map->SetBake(nullptr, nullptr));
  EXPECT_FALSE(this->Map->HasBake());
}
