// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rooms of boxes with a lamp, lit by one technique and measured by the radiance of their pixels.
 */
#pragma once

#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace penumbra_test
{
using Values = std::vector<double>;

/// Mean squared error relative to the truth.
inline double SquaredError(const Values& values, const Values& truth)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sum += std::pow(values[i] - truth[i], 2.0) / (truth[i] * truth[i] + 1e-4);
  }
  return sum / static_cast<double>(values.size());
}

class RoomStage : public ::testing::Test
{
protected:
  /// Set up the window, the pass with one technique enabled, and a lamp of intensity 0.
  void Prepare(const char* technique, int width, int height)
  {
    this->Scene.Window->SetSize(width, height);
    this->Scene.Renderer->AutomaticLightCreationOff();
    this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Pass->KeepRadianceOn();
    ASSERT_NE(this->Pass->GetTechnique(technique), nullptr);
    this->Pass->GetTechnique(technique)->EnabledOn();
    this->Lamp->SetLightTypeToSceneLight();
    ShineAllRound(this->Lamp);
    this->Lamp->SetIntensity(0.0);
    this->Scene.Renderer->AddLight(this->Lamp);
  }

  /// Give a prop a white matte material.
  static vtkActor* Paint(vtkActor* actor, double albedo)
  {
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    actor->GetProperty()->SetDiffuse(albedo);
    actor->GetProperty()->SetAmbient(0.0);
    return actor;
  }

  vtkActor* AddBox(double x0, double x1, double y0, double y1, double z0, double z1, double albedo)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(x0, x1, y0, y1, z0, z1);
    vtkActor* box = Paint(this->Scene.Add(cube), albedo);
    box->GetProperty()->SetInterpolationToFlat();
    return box;
  }

  /// Add two closed rooms of 2 x 2 x 2 with a wall of this thickness between them, and put the lamp into the left one.
  std::array<vtkActor*, 2> AddTwoRooms(double thickness)
  {
    this->Lamp->SetPosition(-1.2, 0.3, 0.4);
    return { this->AddBox(-2.0, -0.5 * thickness, -1.0, 1.0, -1.0, 1.0, 0.7),
      this->AddBox(0.5 * thickness, 2.0, -1.0, 1.0, -1.0, 1.0, 0.7) };
  }

  /// A square of hills around the z axis.
  void AddHills(int points, double z, double height, double frequency)
  {
    const vtkSmartPointer<vtkPolyData> hills = GridAround(1.0, points, z);
    for (vtkIdType i = 0; i < hills->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> p;
      hills->GetPoint(i, p.data());
      p[2] += height * std::sin(frequency * p[0]) * std::sin(frequency * p[1]);
      hills->GetPoints()->SetPoint(i, p.data());
    }
    Paint(this->Scene.Add(hills.Get()), 0.7);
  }

  /// Place the camera, with the z axis up.
  void LookFrom(double x, double y, double z, double atX, double atY, double atZ)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(x, y, z);
    camera->SetFocalPoint(atX, atY, atZ);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(75.0);
    camera->SetClippingRange(0.01, 20.0);
  }

  /// Add a room with a block that hides a part of its ceiling from the eye, where a panel shines. Returns the panel's.
  vtkProperty* AddRoomWithPanel()
  {
    this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
    this->AddBox(-0.7, -0.2, -0.6, -0.1, -1.0, 0.1, 0.6);
    vtkProperty* panel =
      Paint(AddFloor(this->Scene, -0.3, 0.3, -0.3, 0.3, 0.999), 0.0)->GetProperty();
    panel->SetAmbient(1.0);
    this->LookFrom(0.9, 0.8, 0.3, -0.5, -0.5, -0.6);
    return panel;
  }

  /// Replace the scene by a block of reflectance 0.6 in a room whose walls shine with 0.5. The block is as bright as
  /// 0.3 wherever it is seen.
  void ShowBlockInUniformLight()
  {
    this->Scene.Renderer->RemoveAllViewProps();
    this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0)->GetProperty()->SetAmbient(0.5);
    this->AddBox(-0.7, -0.2, -0.6, -0.1, -0.9, 0.1, 0.6);
  }

  /// Expect the mean brightness of that block.
  static void ExpectUniformLight(const Values& picture)
  {
    double sum = 0.0;
    double count = 0.0;
    for (const double value : picture)
    {
      if (std::abs(value - 0.5) > 1e-4) // the block; walls show their emission
      {
        sum += value;
        count += 1.0;
      }
    }
    std::printf("%.4f of 0.3, on %.0f pixels\n", sum / count, count);
    EXPECT_GT(count, 0.05 * static_cast<double>(picture.size()));
    EXPECT_NEAR(sum / count, 0.6 * 0.5, 0.02 * 0.3);
  }

  /// Mean of the colour channels of each pixel after a number of frames.
  Values After(int frames)
  {
    for (int i = 0; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, image));
    Values values;
    auto* scalars = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      values.push_back((scalars->GetTypedComponent(i, 0) + scalars->GetTypedComponent(i, 1) +
                         scalars->GetTypedComponent(i, 2)) /
        3.0);
    }
    return values;
  }

  static double Mean(const Values& values)
  {
    double sum = 0.0;
    for (const double value : values)
    {
      sum += value;
    }
    return sum / static_cast<double>(values.size());
  }

  /// Mean of squared errors relative to the truth, as of penumbra.relative_error().
  static double RelativeSquaredError(const Values& values, const Values& truth)
  {
    const double epsilon = 0.01 * Mean(truth) * Mean(truth);
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sum += std::pow(values[i] - truth[i], 2.0) / (truth[i] * truth[i] + epsilon);
    }
    return sum / static_cast<double>(values.size());
  }

  /// Largest relative error against the same value everywhere.
  static double LargestError(const Values& values, double expected)
  {
    double largest = 0.0;
    for (const double value : values)
    {
      largest = std::max(largest, std::abs(value / expected - 1.0));
    }
    return largest;
  }

  Stage Scene;
  vtkNew<vtkLight> Lamp;
  vtkSmartPointer<vtkGIPass> Pass;
};
}
