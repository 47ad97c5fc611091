// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A wall with a lightmap of known light.
 */
#pragma once

#include "LightmapScene.h"
#include "Messages.h"
#include "Picture.h"

#include <vtkCubeSource.h>
#include <vtkLightCollection.h>

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra_test
{
class LightmapTechnique
  : public ::testing::Test
  , protected LightmapScene
{
protected:
  void SetUp() override { this->Pass->KeepRadianceOn(); }
  void TearDown() override
  {
    for (const std::string& message : TakeMessages())
    {
      ADD_FAILURE() << message;
    }
  }

  void Bake(int channels = 3)
  {
    ASSERT_TRUE(this->Map->SetBake(this->Surfaces(), Light(channels)));
  }

  // Radiance at a position from 0 to 1 across the picture, of the next frame or of the last one.
  double RadianceAt(double x, double y, bool draw = true)
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

  // Tilt the wall's normals toward x by an angle with this sine.
  void TiltNormals(double sine)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-2.0, -2.0, 0.0);
    source->SetPoint1(2.0, -2.0, 0.0);
    source->SetPoint2(-2.0, 2.0, 0.0);
    source->Update();
    vtkNew<vtkPolyData> tilted;
    tilted->DeepCopy(source->GetOutput());
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (int i = 0; i < 4; ++i)
    {
      normals->InsertNextTuple3(sine, 0.0, std::sqrt(1.0 - sine * sine));
    }
    tilted->GetPointData()->SetNormals(normals);
    vtkPolyDataMapper::SafeDownCast(this->Wall->GetMapper())->SetInputData(tilted);
    this->Wall->GetProperty()->SetInterpolationToPhong();
  }

  // Expect that the next frame has no baked light and reports why.
  void ExpectStale(const char* why)
  {
    const double left = this->RadianceAt(0.2, 0.5);
    EXPECT_LT(left, 0.01) << why;
    EXPECT_NE(this->Notes().find(why), std::string::npos) << this->Notes();
    EXPECT_NE(this->Map->GetMismatch(this->Scene.Renderer).find(why), std::string::npos);
  }
  // Expect baked light in the next frame, and no notes.
  void ExpectFits()
  {
    EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.3, 0.002);
    EXPECT_EQ(this->Notes(), "");
    EXPECT_EQ(this->Map->GetMismatch(this->Scene.Renderer), "");
  }
};
}
