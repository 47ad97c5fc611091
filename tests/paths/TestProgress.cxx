// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// How far tracing has come is told of each eye, and can be gone on from.
#include "Agreement.h"

#include "vtkGIPathTracing.h"
#include "vtkImageData.h"
#include "vtkSphereSource.h"

using namespace penumbra_test;

namespace
{
constexpr int Side = 48;

struct Traced
{
  Traced()
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

TEST(Progress, EachEyeHasItsOwn)
{
  Traced traced;
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

// The image that holds the progress may be filled anew before the frame that goes on from it.
TEST(Progress, GoesOnFromWhatItWas)
{
  Traced whole;
  const Picture expected = whole.Frames(5);

  Traced first;
  first.Frames(2);
  vtkNew<vtkImageData> kept;
  ASSERT_TRUE(first.Paths->GetProgress(first.Pass, first.Stage.Renderer, kept));
  Traced second;
  ASSERT_TRUE(second.Paths->SetProgress(second.Stage.Renderer, kept));
  first.Frames(1);
  ASSERT_TRUE(first.Paths->GetProgress(first.Pass, first.Stage.Renderer, kept));
  const Picture gone = second.Frames(3);
  EXPECT_EQ(second.Paths->GetSamplesTaken(second.Stage.Renderer), 5);
  EXPECT_EQ(gone.Pixels, expected.Pixels);
}
