// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress of path tracing is counted per eye, and can be saved and resumed.
#include "Agreement.h"

#include "vtkGIPathTracing.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <cstdio>
#include <vector>

using namespace penumbra_test;

namespace
{
constexpr int Side = 48;

struct TracedBall
{
  TracedBall()
  {
    this->Stage.Window->SetSize(Side, Side);
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(32);
    ball->SetPhiResolution(16);
    this->Stage.Add(ball);
    Stage::LookAround(this->Stage.Renderer);
    this->Pass = this->Stage.SetPasses().front();
    this->Paths = vtkGIPathTracing::SafeDownCast(this->Pass->GetTechnique("path-tracing"));
    this->Paths->EnabledOn();
  }

  Picture Frames(int count)
  {
    for (int i = 1; i < count; ++i)
    {
      this->Stage.Window->Render();
    }
    return Shoot(this->Stage.Window);
  }

  penumbra_test::Stage Stage;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGIPathTracing* Paths = nullptr;
};
}

TEST(Progress, IsCountedPerEye)
{
  TracedBall traced;
  traced.Paths->SetSamples(6);
  traced.Stage.Window->SetStereoType(VTK_STEREO_SPLITVIEWPORT_HORIZONTAL);
  traced.Stage.Window->StereoRenderOn();
  traced.Frames(4);
  EXPECT_EQ(traced.Paths->GetSamplesTaken(traced.Stage.Renderer), 4);
  EXPECT_FALSE(traced.Paths->IsFinished(traced.Stage.Renderer));
  traced.Frames(6);
  EXPECT_EQ(traced.Paths->GetSamplesTaken(traced.Stage.Renderer), 6);
  EXPECT_TRUE(traced.Paths->IsFinished(traced.Stage.Renderer));
}

// The image with the progress may be overwritten before the frame that resumes from it.
TEST(Progress, ResumesWithTheSamePicture)
{
  TracedBall whole;
  const Picture expected = whole.Frames(5);

  TracedBall first;
  first.Frames(2);
  vtkNew<vtkImageData> kept;
  ASSERT_TRUE(first.Paths->GetProgress(first.Pass, first.Stage.Renderer, kept));
  TracedBall second;
  ASSERT_TRUE(second.Paths->SetProgress(second.Stage.Renderer, kept));
  first.Frames(1);
  ASSERT_TRUE(first.Paths->GetProgress(first.Pass, first.Stage.Renderer, kept));
  const Picture resumed = second.Frames(3);
  EXPECT_EQ(second.Paths->GetSamplesTaken(second.Stage.Renderer), 5);
  EXPECT_EQ(resumed.Pixels, expected.Pixels);
}

// A texture does not report changed pixels of its image.
TEST(Progress, StartsFromScratchWhenATexturesImageChanges)
{
  constexpr int side = 64;
  Stage stage;
  stage.Window->SetSize(side, side);
  vtkNew<vtkPlaneSource> plane;
  vtkActor* actor = stage.Add(plane);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(200.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
  auto pass = stage.SetPasses().front();
  auto* paths = vtkGIPathTracing::SafeDownCast(pass->GetTechnique("path-tracing"));
  paths->EnabledOn();
  Shoot(stage.Window);
  EXPECT_EQ(Shoot(stage.Window).At(side / 2, side / 2)[1], 200);
  EXPECT_EQ(paths->GetSamplesTaken(stage.Renderer), 2);
  image->GetPointData()->GetScalars()->Fill(90.0);
  image->Modified();
  EXPECT_EQ(Shoot(stage.Window).At(side / 2, side / 2)[1], 90);
  EXPECT_EQ(paths->GetSamplesTaken(stage.Renderer), 1);
}

// Pictures with different seeds differ from their mean independently, and each seed draws the same picture again.
TEST(Progress, SeedsAreIndependent)
{
  TracedBall traced;
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-1.0, -1.0, -0.6);
  ground->SetPoint1(1.0, -1.0, -0.6);
  ground->SetPoint2(-1.0, 1.0, -0.6);
  traced.Stage.Add(ground);
  vtkProperty* ball = traced.Stage.Renderer->GetActors()->GetLastActor()->GetProperty();
  ball->SetAmbient(0.7); // glows
  traced.Stage.Renderer->ResetCamera();
  const auto draw = [&traced](int seed) {
    traced.Paths->SetSeed(seed);
    const Picture picture = traced.Frames(2);
    EXPECT_EQ(traced.Paths->GetSamplesTaken(traced.Stage.Renderer), 2);
    return picture;
  };
  constexpr int seeds = 24;
  std::vector<Picture> pictures;
  std::vector<double> mean;
  for (int seed = 0; seed < seeds; ++seed)
  {
    pictures.push_back(draw(seed));
    mean.resize(pictures.back().Pixels.size());
    for (std::size_t i = 0; i < mean.size(); ++i)
    {
      mean[i] += static_cast<double>(pictures.back().Pixels[i]) / seeds;
    }
  }
  EXPECT_EQ(draw(0).Pixels, pictures[0].Pixels);
  double squares = 0.0;
  double products = 0.0;
  for (int seed = 1; seed < seeds; ++seed)
  {
    for (std::size_t i = 0; i < mean.size(); ++i)
    {
      const double difference = pictures[seed].Pixels[i] - mean[i];
      squares += difference * difference;
      products += difference * (pictures[seed - 1].Pixels[i] - mean[i]);
    }
  }
  std::printf("correlation of successive seeds: %.3f\n", products / squares);
  EXPECT_GT(squares / seeds, 1e4);
  EXPECT_NEAR(products / squares, -1.0 / seeds, 0.05); // as the mean contains both
}
