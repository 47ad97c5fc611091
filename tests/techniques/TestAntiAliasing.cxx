// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Anti-aliasing against a picture of 64 samples per pixel: the first frame is no worse than VTK's FXAA, frames at rest
 * get better than 8 samples, and changes show at once.
 */
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "technique/StillFrames.h"
#include "vtkGITechnique.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkConeSource.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSuperquadricSource.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

using namespace penumbra_test;

namespace
{
using Average = std::vector<double>;

class AntiAliasing : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(320, 240);
    vtkNew<vtkSuperquadricSource> ring;
    ring->ToroidalOn();
    ring->SetThetaResolution(80);
    ring->SetPhiResolution(60);
    vtkActor* actor = this->Scene.Add(ring);
    actor->RotateX(60.0);
    actor->GetProperty()->SetColor(1.0, 0.6, 0.2);
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(5);
    cone->SetHeight(2.0);
    cone->SetRadius(0.2);
    this->Cone = this->Scene.Add(cone);
    this->Cone->RotateZ(31.0);
    Stage::LookAround(this->Scene.Renderer);
    this->Reference = this->Supersampled(8);
  }

  Picture ShootShifted(double x, double y)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    const int* size = this->Scene.Window->GetSize();
    camera->SetWindowCenter(2.0 * x / size[0], 2.0 * y / size[1]);
    const Picture picture = Shoot(this->Scene.Window);
    camera->SetWindowCenter(0.0, 0.0);
    return picture;
  }

  static void Accumulate(Average& sum, const Picture& picture)
  {
    sum.resize(picture.Pixels.size());
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      sum[i] += picture.Pixels[i];
    }
  }

  // Stock VTK's picture with a grid of side x side samples per pixel.
  Average Supersampled(int side)
  {
    Average sum;
    for (int i = 0; i < side * side; ++i)
    {
      Accumulate(
        sum, this->ShootShifted((i % side + 0.5) / side - 0.5, (i / side + 0.5) / side - 0.5));
    }
    for (double& value : sum)
    {
      value /= side * side;
    }
    return sum;
  }

  // Root mean square difference from the reference, in 1/255.
  double Error(const Average& picture) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      const double d = picture[i] - this->Reference[i];
      sum += d * d;
    }
    return std::sqrt(sum / picture.size());
  }
  double Error(const Picture& picture) const
  {
    return this->Error(Average(picture.Pixels.begin(), picture.Pixels.end()));
  }

  // Errors of the next still frames, by their number.
  std::map<int, double> StillErrors(int last)
  {
    std::map<int, double> errors;
    for (int frames = 1; frames <= last; ++frames)
    {
      errors[frames] = this->Error(Shoot(this->Scene.Window));
    }
    return errors;
  }

  // A pass that averages still frames. edges: value of the parameter.
  vtkSmartPointer<vtkGIPass> Smooth(const char* edges)
  {
    vtkSmartPointer<vtkGIPass> pass = this->Scene.SetPasses().front();
    pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
    pass->GetTechnique("anti-aliasing")->SetParameterFromText("edges", edges);
    return pass;
  }

  // Replaces the scene by a plane with waves along both sides.
  vtkActor* AddWaves(int resolution, double height, double x, double y)
  {
    this->Scene.Renderer->RemoveAllViewProps();
    vtkNew<vtkPlaneSource> plane;
    plane->SetResolution(resolution, resolution);
    plane->Update();
    vtkPoints* points = plane->GetOutput()->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double at[3];
      points->GetPoint(i, at);
      at[2] = height * std::sin(x * at[0]) * std::cos(y * at[1]);
      points->SetPoint(i, at);
    }
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(plane->GetOutput());
    vtkActor* actor = this->Scene.Add(normals);
    actor->RotateX(-30.0);
    Stage::LookAround(this->Scene.Renderer);
    return actor;
  }

  // Errors of a first frame without rays and with them.
  std::array<double, 2> FirstFrameErrors(const char* material)
  {
    this->Scene.Renderer->SetPass(nullptr);
    this->Reference = this->Supersampled(8);
    std::array<double, 2> errors;
    for (int i = 0; i < 2; ++i)
    {
      this->Smooth(i == 0 ? "frames" : "rays");
      errors[i] = this->Error(Shoot(this->Scene.Window));
    }
    std::printf("%s, first frame: error %.3f, with rays %.3f\n", material, errors[0], errors[1]);
    return errors;
  }

  Stage Scene;
  vtkActor* Cone = nullptr;
  Average Reference;
};

// Positions of the 8 multisamples of Direct3D 11, in sixteenths of a pixel.
constexpr std::array<std::array<int, 2>, 8> Multisamples = { { { { 1, -3 } }, { { -1, 3 } },
  { { 5, 1 } }, { { -3, -5 } }, { { -5, 5 } }, { { -7, -1 } }, { { 3, 7 } }, { { 7, -7 } } } };
}

TEST_F(AntiAliasing, FirstFrameMatchesFXAAAndFramesAtRestBeatEightSamples)
{
  const double none = this->Error(Shoot(this->Scene.Window));
  this->Scene.Renderer->UseFXAAOn();
  const double fxaa = this->Error(Shoot(this->Scene.Window));
  this->Scene.Renderer->UseFXAAOff();
  Average eight;
  for (const auto& position : Multisamples)
  {
    Accumulate(eight, this->ShootShifted(position[0] / 16.0, position[1] / 16.0));
  }
  for (double& value : eight)
  {
    value /= 8.0;
  }
  const double msaa = this->Error(eight);

  vtkSmartPointer<vtkGIPass> pass = this->Smooth("frames");
  std::map<int, double> still = this->StillErrors(64);
  EXPECT_EQ(pass->GetAccumulatedFrames(this->Scene.Renderer), 64);
  std::printf("error in 1/255: none %.3f, FXAA %.3f, 8 samples %.3f; pass: one frame %.3f, "
              "2 still frames %.3f, 3 %.3f, 9 %.3f, 17 %.3f, 64 %.3f\n",
    none, fxaa, msaa, still[1], still[2], still[3], still[9], still[17], still[64]);
  EXPECT_LE(still[1], fxaa);
  EXPECT_LT(still[3], 0.7 * still[1]);
  // The second frame is shifted, and mirrored by the third only.
  EXPECT_LT(still[2], still[1]);
  EXPECT_LT(still[17], msaa);
  EXPECT_LT(still[64], 0.33 * msaa);
}

TEST_F(AntiAliasing, RaysSmoothEdgesFromTheFirstFrame)
{
  this->Smooth("frames");
  std::map<int, double> frames = this->StillErrors(24);
  const Picture last = Shoot(this->Scene.Window);
  this->Smooth("rays");
  std::map<int, double> rays = this->StillErrors(24);
  for (const int number : { 1, 2, 3, 5, 8 })
  {
    std::printf("%d frames: error %.3f, with rays %.3f\n", number, frames[number], rays[number]);
    EXPECT_LT(rays[number], 0.8 * frames[number]) << number;
  }
  EXPECT_LT(rays[1], 0.5 * frames[1]);
  // The weight of the coverage is 0 by now.
  EXPECT_EQ(Compare(last, Shoot(this->Scene.Window), 0).Within, 1.0);
}

// Waves a few pixels long: rays hit surfaces near the pixel's own plane that face elsewhere.
TEST_F(AntiAliasing, RaysShadeWhatTheyHit)
{
  this->AddWaves(400, 0.006, 200.0, 170.0);
  const std::array<double, 2> errors = this->FirstFrameErrors("Phong");
  EXPECT_LT(errors[1], 0.4 * errors[0]);
}

// The same without borders in the picture. VTK encodes PBR materials' colours for display.
TEST_F(AntiAliasing, RaysShadeMaterialsByWhatTheyReflect)
{
  vtkProperty* look = this->AddWaves(600, 0.0025, 480.0, 410.0)->GetProperty();
  this->Scene.Renderer->GetActiveCamera()->Zoom(2.5);
  const std::array<double, 2> phong = this->FirstFrameErrors("Phong");
  look->SetAmbient(0.8);
  look->SetDiffuse(0.2);
  const std::array<double, 2> glow = this->FirstFrameErrors("glow");
  look->SetInterpolationToPBR();
  look->SetRoughness(1.0);
  const std::array<double, 2> pbr = this->FirstFrameErrors("PBR");
  EXPECT_LT(phong[1], 0.5 * phong[0]);
  EXPECT_LT(glow[1], 0.6 * glow[0]);
  EXPECT_LT(pbr[1], 0.6 * pbr[0]);
}

// Coplanar faces that differ in colour only.
TEST_F(AntiAliasing, RaysSmoothBordersOfColours)
{
  this->Scene.Renderer->RemoveAllViewProps();
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(7, 5);
  plane->Update();
  vtkPolyData* squares = plane->GetOutput();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < squares->GetNumberOfCells(); ++cell)
  {
    const bool light = cell % 2 == 0;
    colors->InsertNextTuple3(light ? 230 : 20, light ? 200 : 60, light ? 40 : 160);
  }
  squares->GetCellData()->SetScalars(colors);
  this->Scene.Add(plane)->RotateZ(17.0);
  Stage::LookAround(this->Scene.Renderer);
  this->Reference = this->Supersampled(8);
  const double none = this->Error(Shoot(this->Scene.Window));
  this->Smooth("frames");
  const std::map<int, double> frames = this->StillErrors(3);
  this->Smooth("rays");
  const std::map<int, double> rays = this->StillErrors(3);
  std::printf("error %.3f; one frame %.3f, with rays %.3f; 3 frames %.3f, with rays %.3f\n", none,
    frames.at(1), rays.at(1), frames.at(3), rays.at(3));
  EXPECT_LT(rays.at(1), 0.4 * none);
  EXPECT_LT(rays.at(3), 0.6 * frames.at(3));
}

// Rays do not hit lines.
TEST_F(AntiAliasing, RaysLeaveLinesAsTheyAre)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-1.0, -0.4, 1.2);
  line->SetPoint2(1.0, 0.5, 1.2);
  vtkActor* drawn = this->Scene.Add(line);
  drawn->GetProperty()->LightingOff();
  drawn->GetProperty()->SetColor(0.0, 1.0, 0.0);
  const auto green = [](const Picture& picture) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 2 < picture.Pixels.size(); i += 3)
    {
      const int more = picture.Pixels[i + 1] - std::max(picture.Pixels[i], picture.Pixels[i + 2]);
      sum += more > 100 ? more : 0;
    }
    return sum;
  };
  this->Smooth("frames");
  const double frames = green(Shoot(this->Scene.Window));
  this->Smooth("rays");
  const double rays = green(Shoot(this->Scene.Window));
  std::printf("green of the line %.0f, with rays %.0f\n", frames, rays);
  EXPECT_GT(frames, 1e4);
  EXPECT_NEAR(rays, frames, 0.05 * frames);
}

// The mean of an odd number of frames is not shifted against the first.
TEST(StillFrames, AreShiftedAroundTheirPixels)
{
  glm::dvec2 sum(0.0);
  for (int index = 0; index < 1000; ++index)
  {
    const glm::dvec2 shift = penumbra::StillFrameShift(index);
    EXPECT_LE(std::max(std::abs(shift.x), std::abs(shift.y)), 0.5) << index;
    sum += shift;
    if (index % 2 == 0)
    {
      EXPECT_NEAR(sum.x, 0.0, 1e-9) << index;
      EXPECT_NEAR(sum.y, 0.0, 1e-9) << index;
    }
  }
}

TEST_F(AntiAliasing, ChangesShowAtOnceAndCompletely)
{
  vtkSmartPointer<vtkGIPass> pass = this->Scene.SetPasses().front();
  pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
  for (int i = 0; i < 10; ++i)
  {
    Shoot(this->Scene.Window);
  }
  this->Cone->VisibilityOff();
  const Picture changed = Shoot(this->Scene.Window);
  EXPECT_EQ(pass->GetAccumulatedFrames(this->Scene.Renderer), 1);
  this->Scene.Renderer->SetPass(nullptr);
  vtkSmartPointer<vtkGIPass> fresh = this->Scene.SetPasses().front();
  fresh->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
  EXPECT_EQ(Compare(changed, Shoot(this->Scene.Window), 0).Within, 1.0);
}

TEST_F(AntiAliasing, IsOnByDefaultInMultisampledWindows)
{
  this->Scene.Window->SetMultiSamples(4);
  const double stock = this->Error(Shoot(this->Scene.Window));
  vtkSmartPointer<vtkGIPass> pass = this->Scene.SetPasses().front();
  double error = 0.0;
  for (int i = 0; i < 32; ++i)
  {
    error = this->Error(Shoot(this->Scene.Window));
  }
  std::printf(
    "error in 1/255: stock with 4 samples %.3f, pass after 32 frames %.3f\n", stock, error);
  EXPECT_LT(error, stock);
}
