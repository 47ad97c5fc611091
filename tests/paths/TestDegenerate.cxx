// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Extremes: tiny props, and invalid normals.
#include "Agreement.h"

#include "vtkFloatArray.h"
#include "vtkGITechnique.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <limits>

using namespace penumbra_test;

namespace
{
vtkSmartPointer<vtkPolyData> Ball(double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(24);
  source->SetPhiResolution(24);
  source->Update();
  return source->GetOutput();
}

// Draw the ball with every component of its normals set to a value, or without normals if the value is 1. technique is
// nullptr for stock VTK and empty for a pass without techniques.
Picture Draw(double normal, const char* technique, std::string* notes = nullptr)
{
  Stage stage;
  stage.Window->SetSize(96, 96);
  auto ball = Ball(0.5);
  if (normal == 1.0)
  {
    ball->GetPointData()->SetNormals(nullptr);
  }
  else
  {
    ball->GetPointData()->GetNormals()->Fill(normal);
  }
  stage.Add(ball);
  LightFromCamera(stage);
  if (technique)
  {
    auto pass = stage.SetPasses().front();
    pass->GetTechnique("anti-aliasing")->EnabledOff();
    if (*technique)
    {
      pass->GetTechnique(technique)->EnabledOn();
    }
    const Picture picture = Shoot(stage.Window);
    if (notes)
    {
      *notes = pass->GetNotes();
    }
    return picture;
  }
  return Shoot(stage.Window);
}
}

TEST(Degenerate, TinyBallsAgree)
{
  for (const double radius : { 1e-6, 1e-12 })
  {
    Stage stage;
    stage.Window->SetSize(96, 96);
    stage.Add(Ball(radius));
    LightFromCamera(stage);
    ExpectAgreement(stage, "ball-of-" + std::to_string(-std::log10(radius)));
  }
}

// Normals that are zero or NaN count as missing. With every technique off the picture is VTK's.
TEST(Degenerate, InvalidNormalsCountAsMissing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const char* technique : { "ambient-occlusion", "path-tracing" })
  {
    const Picture expected = Draw(1.0, technique);
    EXPECT_GT(expected.MeanGrey(40, 40, 56, 56), 100.0);
    for (const double normal : { 0.0, nan })
    {
      std::string notes;
      const Picture found = Draw(normal, technique, &notes);
      const Difference difference = Compare(found, expected, 2);
      std::printf("%s, normals of %g: %.4f alike\n", technique, normal, difference.Within);
      EXPECT_GE(difference.Within, 0.99) << technique << ' ' << normal;
      const bool traced = std::string(technique) == "path-tracing";
      EXPECT_EQ(notes.find("normals that are zero") != std::string::npos, traced) << notes;
    }
  }
  EXPECT_EQ(Compare(Draw(0.0, ""), Draw(0.0, nullptr), 1).Within, 1.0);
  std::string notes;
  Draw(1.0, "path-tracing", &notes);
  EXPECT_EQ(notes, "");
}
