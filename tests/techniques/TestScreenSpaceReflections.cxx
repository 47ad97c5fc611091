// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Screen-space reflections: on a planar mirror they are what a camera behind the mirror sees, wherever
 * the screen shows it; elsewhere every pixel says why not.
 */
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include "private/Matrices.h"
#include "reflection.h"

#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
// Window coordinates (pixels, depth) to the world and back.
struct Lens
{
  Lens(vtkRenderer* renderer, int width, int height)
    : Size(width, height)
  {
    vtkMatrix4x4* matrix =
      renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0 * width / height, -1, 1);
    this->ToClip = penumbra::ToMatrix(matrix);
    this->ToWorld = glm::inverse(this->ToClip);
  }
  glm::dvec3 World(const glm::dvec3& window) const
  {
    const glm::dvec3 ndc(2.0 * glm::dvec2(window) / this->Size - 1.0, 2.0 * window.z - 1.0);
    const glm::dvec4 p = this->ToWorld * glm::dvec4(ndc, 1.0);
    return glm::dvec3(p) / p.w;
  }
  glm::dvec3 Window(const glm::dvec3& world) const
  {
    const glm::dvec4 p = this->ToClip * glm::dvec4(world, 1.0);
    const glm::dvec3 ndc = 0.5 * glm::dvec3(p) / p.w + 0.5;
    return glm::dvec3(glm::dvec2(ndc) * this->Size, ndc.z);
  }
  glm::dvec2 Size;
  glm::dmat4 ToClip;
  glm::dmat4 ToWorld;
};

class ScreenSpaceReflections : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(401, 303); // odd, so that the pyramid's levels are rounded up
    this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Reflections = this->Pass->GetTechnique("screen-space-reflections");
    ASSERT_NE(this->Reflections, nullptr);
    this->Reflections->EnabledOn();
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-4.0, -4.0, 0.0);
    plane->SetPoint1(4.0, -4.0, 0.0);
    plane->SetPoint2(-4.0, 4.0, 0.0);
    this->Floor = this->Scene.Add(plane);
    this->Mirror(0.0);
  }
  void TearDown() override { EXPECT_TRUE(TakeMessages().empty()); }

  void Mirror(double roughness)
  {
    this->Floor->GetProperty()->SetInterpolationToPBR();
    this->Floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    this->Floor->GetProperty()->SetMetallic(1.0);
    this->Floor->GetProperty()->SetRoughness(roughness);
  }

  // Flat and round, thick and thin, standing and floating.
  void AddThings()
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(-1.8, -0.8, -0.5, 0.5, 0.0, 1.1);
    this->Scene.Add(box);
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0.1, -0.6, 0.6);
    ball->SetRadius(0.5);
    ball->SetThetaResolution(96);
    ball->SetPhiResolution(96);
    this->Scene.Add(ball);
    vtkNew<vtkParametricTorus> ring;
    ring->SetRingRadius(0.5);
    ring->SetCrossSectionRadius(0.12);
    vtkNew<vtkParametricFunctionSource> round;
    round->SetParametricFunction(ring);
    round->SetUResolution(96);
    round->SetVResolution(48);
    vtkActor* torus = this->Scene.Add(round);
    torus->RotateX(70.0);
    torus->SetPosition(1.4, 0.2, 0.8);
    vtkNew<vtkCylinderSource> pole;
    pole->SetRadius(0.03);
    pole->SetHeight(1.6);
    pole->SetResolution(24);
    for (double x : { -0.5, 0.8, 2.2 })
    {
      vtkActor* actor = this->Scene.Add(pole);
      actor->RotateX(90.0);
      actor->SetPosition(x, 1.0, 0.8);
    }
    vtkNew<vtkCubeSource> wall;
    wall->SetBounds(-3.0, 3.0, 2.4, 2.6, 0.0, 2.2);
    this->Scene.Add(wall);
  }

  void Look(double x, double y, double z, bool parallel, bool mirrored)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    const double side = mirrored ? -1.0 : 1.0;
    camera->SetPosition(x, y, side * z);
    camera->SetFocalPoint(0.0, 0.0, side * 0.5);
    camera->SetViewUp(0.0, 0.0, side);
    camera->SetViewAngle(35.0);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(1.9);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  // How rays ended: pixel x and y, reason, confidence.
  std::vector<glm::vec4> Ends()
  {
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(
      this->Pass->GetBuffer(this->Scene.Renderer, "screen-space-reflections.ends", image));
    const auto* values = static_cast<const glm::vec4*>(image->GetScalarPointer());
    return { values, values + image->GetNumberOfPoints() };
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGITechnique* Reflections = nullptr;
  vtkActor* Floor = nullptr;
};

struct Agreement
{
  int Expected = 0;  ///< pixels whose reflection the screen shows
  int Near = 0;      ///< of those, found within a pixel
  int Missed = 0;    ///< of those, not found
  int Found = 0;     ///< all that found something
  int False = 0;     ///< of those, what they should not have found, by more than two pixels
  int LongestRun = 0; ///< of False pixels beside or above each other
};
}

TEST_F(ScreenSpaceReflections, a_mirror_shows_what_a_camera_behind_it_sees)
{
  this->AddThings();
  this->Reflections->SetParameterFromText("debug-view", "reasons");
  std::printf("%-28s %9s %9s %9s %9s %9s\n", "view", "expected", "within 1", "missed", "false", "run");
  struct Eye
  {
    double X, Y, Z;
    bool Parallel;
  };
  for (const Eye& eye : { Eye{ 0, -6, 2.5, false }, Eye{ 3, -5, 1.2, false },
         Eye{ -2, -4, 4, false }, Eye{ 0, -6, 2.5, true }, Eye{ 3, -5, 1.5, true } })
  {
    this->Floor->VisibilityOn();
    this->Look(eye.X, eye.Y, eye.Z, eye.Parallel, false);
    const Picture seen = Shoot(this->Scene.Window);
    const std::vector<glm::vec4> ends = this->Ends();
    const Lens lens(this->Scene.Renderer, seen.Width, seen.Height);
    this->Floor->VisibilityOff();
    this->Look(eye.X, eye.Y, eye.Z, eye.Parallel, true);
    const Picture behind = Shoot(this->Scene.Window);
    const Lens mirrored(this->Scene.Renderer, seen.Width, seen.Height);

    Agreement found;
    Picture map = seen; // green: right, red: wrong, blue: missed, yellow: should not have been found
    std::vector<int> columns(seen.Width, 0);
    for (int y = 0; y < seen.Height; ++y)
    {
      int row = 0;
      for (int x = 0; x < seen.Width; ++x)
      {
        const glm::vec4& end = ends[y * seen.Width + x];
        const bool hit = static_cast<int>(end.z) == GI_REFLECTION_HIT;
        const int across = seen.Width - 1 - x;
        const float depth = behind.Depth[y * seen.Width + across];
        bool shown = false;
        bool wrong = hit;
        glm::dvec2 place(-1.0);
        if (static_cast<int>(end.z) != GI_REFLECTION_NONE && depth < 1.0f)
        {
          const glm::dvec3 there = mirrored.World({ across + 0.5, y + 0.5, depth });
          const glm::dvec3 window = lens.Window(there);
          place = glm::dvec2(window);
          if (window.x >= 0 && window.y >= 0 && window.x < seen.Width && window.y < seen.Height)
          {
            const auto at = static_cast<int>(window.y) * seen.Width + static_cast<int>(window.x);
            const glm::dvec3 surface = lens.World({ place, seen.Depth[at] });
            // A pixel is about 0.015 wide here; where the surface is seen edge-on, depth varies more.
            shown = glm::length(surface - there) < 0.03;
          }
          if (hit)
          {
            const auto at = static_cast<int>(end.y) * seen.Width + static_cast<int>(end.x);
            const glm::dvec3 met = lens.World({ end.x, end.y, seen.Depth[at] });
            wrong = glm::length(place - glm::dvec2(end)) > 2.0 || glm::length(met - there) > 0.1;
          }
        }
        const double off = glm::length(place - glm::dvec2(end));
        found.Expected += shown;
        found.Near += shown && hit && off <= 1.0;
        found.Missed += shown && !hit;
        found.Found += hit;
        found.False += wrong;
        row = wrong ? row + 1 : 0;
        columns[x] = wrong ? columns[x] + 1 : 0;
        const std::array<int, 3> tint = shown && hit && off <= 1.0 ? std::array<int, 3>{ 0, 160, 0 }
          : shown && hit ? std::array<int, 3>{ 220, 0, 0 }
          : shown ? std::array<int, 3>{ 60, 60, 255 }
          : wrong ? std::array<int, 3>{ 255, 230, 0 } : std::array<int, 3>{ 60, 60, 60 };
        std::copy(tint.begin(), tint.end(), &map.Pixels[4 * (y * seen.Width + x)]);
        found.LongestRun = std::max({ found.LongestRun, row, columns[x] });
      }
    }
    char name[64];
    std::snprintf(name, sizeof(name), "%s from (%g, %g, %g)", eye.Parallel ? "parallel" : "perspective",
      eye.X, eye.Y, eye.Z);
    std::printf("%-28s %9d %8.2f%% %8.2f%% %8.2f%% %9d\n", name, found.Expected,
      100.0 * found.Near / found.Expected, 100.0 * found.Missed / found.Expected,
      100.0 * found.False / found.Found, found.LongestRun);
    Save(map, name);
    EXPECT_GT(found.Expected, 3000);
    EXPECT_GE(found.Near, 0.98 * found.Expected);
  }
}
