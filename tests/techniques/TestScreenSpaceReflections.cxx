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

// What a camera behind the mirror sees at a pixel, and where the eye would see that.
struct Expected
{
  bool Something = false;
  bool Shown = false; ///< the eye sees it
  glm::dvec3 Point{ 0.0 };
  glm::dvec2 Window{ 0.0 };
};

struct Agreement
{
  int Shown = 0;  ///< pixels whose reflection the screen shows
  int Near = 0;   ///< of those, found within a pixel
  int Missed = 0; ///< of those, not found
  int Found = 0;  ///< all that found something
  int Wrong = 0;  ///< of those, what neither this nor an adjoining pixel reflects
  int Streak = 0; ///< longest run of wrong pixels that is no more than two pixels wide
};

// A pixel is about 0.015 wide in these pictures.
constexpr double SamePoint = 0.03;

bool Matches(const Expected& expected, const glm::dvec3& met, const glm::dvec2& window)
{
  return expected.Something && glm::length(expected.Window - window) <= 2.0 &&
    glm::length(expected.Point - met) <= 4.0 * SamePoint;
}

// The longest run across pixels that are set, where it is at most two wide the other way.
int ThinRun(const std::vector<char>& set, int width, int height, int dx, int dy)
{
  const auto at = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width && y < height && set[y * width + x];
  };
  int longest = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      int run = 0;
      for (; at(x + run * dx, y + run * dy); ++run)
      {
        const int px = x + run * dx;
        const int py = y + run * dy;
        int wide = 1;
        for (int side = 1; side <= 2; ++side)
        {
          wide += at(px + side * dy, py + side * dx) + at(px - side * dy, py - side * dx);
        }
        if (wide > 2)
        {
          break;
        }
      }
      longest = std::max(longest, run);
    }
  }
  return longest;
}
}

namespace
{
// The mirrored camera's picture has left and right exchanged.
std::vector<Expected> MirrorImage(
  const Picture& seen, const Lens& lens, const Picture& behind, const Lens& mirrored)
{
  std::vector<Expected> image(seen.Depth.size());
  for (int y = 0; y < seen.Height; ++y)
  {
    for (int x = 0; x < seen.Width; ++x)
    {
      Expected& pixel = image[y * seen.Width + x];
      const int across = seen.Width - 1 - x;
      const float depth = behind.Depth[y * seen.Width + across];
      pixel.Something = depth < 1.0f;
      pixel.Point = mirrored.World({ across + 0.5, y + 0.5, depth });
      pixel.Window = glm::dvec2(lens.Window(pixel.Point));
      const glm::ivec2 at(glm::floor(pixel.Window));
      if (pixel.Something && at.x >= 0 && at.y >= 0 && at.x < seen.Width && at.y < seen.Height)
      {
        const float surface = seen.Depth[at.y * seen.Width + at.x];
        pixel.Shown =
          glm::length(lens.World({ pixel.Window, surface }) - pixel.Point) < SamePoint;
      }
    }
  }
  return image;
}

Agreement CompareEnds(const std::vector<glm::vec4>& ends, const Picture& seen, const Lens& lens,
  const std::vector<Expected>& image, const std::string& name)
{
  Agreement result;
  Picture map = seen; // green: right, red: off, blue: missed, yellow: wrong
  std::vector<char> wrong(ends.size(), 0);
  for (int y = 0; y < seen.Height; ++y)
  {
    for (int x = 0; x < seen.Width; ++x)
    {
      const std::size_t i = y * seen.Width + x;
      const bool mirror = static_cast<int>(ends[i].z) != GI_REFLECTION_NONE;
      const bool hit = static_cast<int>(ends[i].z) == GI_REFLECTION_HIT;
      const bool shown = mirror && image[i].Shown;
      const glm::dvec2 window(ends[i]);
      const bool right = hit && shown && glm::length(image[i].Window - window) <= 1.0;
      if (hit)
      {
        const std::size_t at =
          static_cast<std::size_t>(window.y) * seen.Width + static_cast<std::size_t>(window.x);
        const glm::dvec3 met = lens.World({ window, seen.Depth[at] });
        bool known = false;
        for (int n = 0; n < 9; ++n)
        {
          const int px = std::clamp(x + n % 3 - 1, 0, seen.Width - 1);
          const int py = std::clamp(y + n / 3 - 1, 0, seen.Height - 1);
          known = known || Matches(image[py * seen.Width + px], met, window);
        }
        wrong[i] = !right && !known;
      }
      result.Shown += shown;
      result.Near += right;
      result.Missed += shown && !hit;
      result.Found += hit;
      result.Wrong += wrong[i];
      const std::array<unsigned char, 3> tint = wrong[i] ? std::array<unsigned char, 3>{ 255, 230, 0 }
        : right                                       ? std::array<unsigned char, 3>{ 0, 160, 0 }
        : shown && hit                                ? std::array<unsigned char, 3>{ 220, 0, 0 }
        : shown                                       ? std::array<unsigned char, 3>{ 60, 60, 255 }
                                                      : std::array<unsigned char, 3>{ 60, 60, 60 };
      std::copy(tint.begin(), tint.end(), &map.Pixels[4 * i]);
    }
  }
  result.Streak = std::max(ThinRun(wrong, seen.Width, seen.Height, 1, 0),
    ThinRun(wrong, seen.Width, seen.Height, 0, 1));
  Save(map, name);
  return result;
}
}

TEST_F(ScreenSpaceReflections, a_mirror_shows_what_a_camera_behind_it_sees)
{
  this->AddThings();
  this->Reflections->SetParameterFromText("debug-view", "reasons");
  std::printf("%-28s %8s %9s %8s %8s %8s\n", "view", "shown", "within 1", "missed", "wrong", "streak");
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

    char name[64];
    std::snprintf(name, sizeof(name), "%s from (%g, %g, %g)", eye.Parallel ? "parallel" : "perspective",
      eye.X, eye.Y, eye.Z);
    const Agreement found =
      CompareEnds(ends, seen, lens, MirrorImage(seen, lens, behind, mirrored), name);
    std::printf("%-28s %8d %8.2f%% %7.2f%% %7.2f%% %8d\n", name, found.Shown,
      100.0 * found.Near / found.Shown, 100.0 * found.Missed / found.Shown,
      100.0 * found.Wrong / found.Found, found.Streak);
    EXPECT_GT(found.Shown, 3000);
    EXPECT_GE(found.Near, 0.98 * found.Shown);
    EXPECT_LE(found.Wrong, 0.03 * found.Found);
    EXPECT_LE(found.Streak, 12);
  }
}
