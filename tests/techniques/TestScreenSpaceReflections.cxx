// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Screen-space reflections: a planar mirror shows what a camera behind it sees, wherever the screen has it. Every other
 * pixel has a reason for its missing reflection.
 */
#include "ReflectionStage.h"

#include "base/Matrices.h"

#include <vtkMatrix4x4.h>
#include <vtkSphereSource.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
using ScreenSpaceReflections = ReflectionStage;

// Converts between window coordinates (pixels, depth) and the world.
struct Projection
{
  Projection(vtkRenderer* renderer, int width, int height)
    : Size(width, height)
  {
    vtkMatrix4x4* matrix = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      1.0 * width / height, -1, 1);
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

// The point that a camera behind the mirror sees at a pixel, and its position in the viewer's picture.
struct MirroredPoint
{
  bool Exists = false;
  bool OnScreen = false; ///< visible in the viewer's picture
  glm::dvec3 Point{ 0.0 };
  glm::dvec2 Window{ 0.0 };
};

struct Agreement
{
  int Shown = 0;  ///< pixels whose reflected point is on the screen
  int Near = 0;   ///< of those, hit within a pixel
  int Missed = 0; ///< of those, not hit
  int Found = 0;  ///< pixels with any hit
  int Wrong = 0;  ///< of those, hits that neither the pixel nor its neighbours reflect
  int Streak = 0; ///< longest run of wrong pixels that is at most two pixels wide
};

// A pixel is about 0.015 wide in these pictures.
constexpr double SamePoint = 0.03;

bool Matches(const MirroredPoint& expected, const glm::dvec3& hit, const glm::dvec2& window)
{
  return expected.Exists && glm::length(expected.Window - window) <= 2.0 &&
    glm::length(expected.Point - hit) <= 4.0 * SamePoint;
}

// Length of the longest run of set pixels along a direction that is at most two pixels wide across it.
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

// The mirrored camera's picture has left and right exchanged.
std::vector<MirroredPoint> MirrorImage(const Picture& seen, const Projection& projection,
  const Picture& behind, const Projection& mirrored)
{
  std::vector<MirroredPoint> image(seen.Depth.size());
  for (int y = 0; y < seen.Height; ++y)
  {
    for (int x = 0; x < seen.Width; ++x)
    {
      MirroredPoint& pixel = image[y * seen.Width + x];
      const int across = seen.Width - 1 - x;
      const float depth = behind.Depth[y * seen.Width + across];
      pixel.Exists = depth < 1.0f;
      pixel.Point = mirrored.World({ across + 0.5, y + 0.5, depth });
      pixel.Window = glm::dvec2(projection.Window(pixel.Point));
      const glm::ivec2 at(glm::floor(pixel.Window));
      if (pixel.Exists && at.x >= 0 && at.y >= 0 && at.x < seen.Width && at.y < seen.Height)
      {
        const float surface = seen.Depth[at.y * seen.Width + at.x];
        pixel.OnScreen =
          glm::length(projection.World({ pixel.Window, surface }) - pixel.Point) < SamePoint;
      }
    }
  }
  return image;
}

Agreement CompareEnds(const std::vector<glm::vec4>& ends, const Picture& seen,
  const Projection& projection, const std::vector<MirroredPoint>& image, const std::string& name)
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
      const bool shown = mirror && image[i].OnScreen;
      const glm::dvec2 window(ends[i]);
      const bool right = hit && shown && glm::length(image[i].Window - window) <= 1.0;
      if (hit)
      {
        const std::size_t at =
          static_cast<std::size_t>(window.y) * seen.Width + static_cast<std::size_t>(window.x);
        const glm::dvec3 point = projection.World({ window, seen.Depth[at] });
        bool known = false;
        for (int n = 0; n < 9; ++n)
        {
          const int px = std::clamp(x + n % 3 - 1, 0, seen.Width - 1);
          const int py = std::clamp(y + n / 3 - 1, 0, seen.Height - 1);
          known = known || Matches(image[py * seen.Width + px], point, window);
        }
        wrong[i] = !right && !known;
      }
      result.Shown += shown;
      result.Near += right;
      result.Missed += shown && !hit;
      result.Found += hit;
      result.Wrong += wrong[i];
      const std::array<unsigned char, 3> tint = wrong[i]
        ? std::array<unsigned char, 3>{ 255, 230, 0 }
        : right        ? std::array<unsigned char, 3>{ 0, 160, 0 }
        : shown && hit ? std::array<unsigned char, 3>{ 220, 0, 0 }
        : shown        ? std::array<unsigned char, 3>{ 60, 60, 255 }
                       : std::array<unsigned char, 3>{ 60, 60, 60 };
      std::copy(tint.begin(), tint.end(), &map.Pixels[4 * i]);
    }
  }
  result.Streak = std::max(
    ThinRun(wrong, seen.Width, seen.Height, 1, 0), ThinRun(wrong, seen.Width, seen.Height, 0, 1));
  Save(map, name);
  return result;
}
}

TEST_F(ScreenSpaceReflections, AMirrorShowsWhatACameraBehindItSees)
{
  this->AddObjects();
  this->Reflections->SetParameterFromText("debug-view", "reasons");
  std::printf(
    "%-28s %8s %9s %8s %8s %8s\n", "view", "shown", "within 1", "missed", "wrong", "streak");
  struct Eye
  {
    double X, Y, Z;
    bool Parallel;
    double Far, Missed, Wrong; ///< largest percentages: of Shown, of Shown, of Found
    int Streak;                ///< largest number of pixels
  };
  for (const Eye& eye : { Eye{ 0, -6, 2.5, false, 2.0, 1.6, 3.0, 12 },
         Eye{ 3, -5, 1.2, false, 1.0, 0.75, 3.0, 10 }, Eye{ -2, -4, 4, false, 1.8, 1.5, 2.2, 6 },
         Eye{ 0, -6, 2.5, true, 0.9, 0.9, 1.2, 12 }, Eye{ 3, -5, 1.5, true, 0.75, 0.6, 2.8, 4 } })
  {
    this->Floor->VisibilityOn();
    this->LookFrom(eye.X, eye.Y, eye.Z, eye.Parallel, false);
    const Picture seen = Shoot(this->Scene.Window);
    const std::vector<glm::vec4> ends = this->Ends();
    const Projection projection(this->Scene.Renderer, seen.Width, seen.Height);
    this->Floor->VisibilityOff();
    this->LookFrom(eye.X, eye.Y, eye.Z, eye.Parallel, true);
    const Picture behind = Shoot(this->Scene.Window);
    const Projection mirrored(this->Scene.Renderer, seen.Width, seen.Height);

    char name[64];
    std::snprintf(name, sizeof(name), "%s from (%g, %g, %g)",
      eye.Parallel ? "parallel" : "perspective", eye.X, eye.Y, eye.Z);
    const Agreement found =
      CompareEnds(ends, seen, projection, MirrorImage(seen, projection, behind, mirrored), name);
    std::printf("%-28s %8d %8.2f%% %7.2f%% %7.2f%% %8d\n", name, found.Shown,
      100.0 * found.Near / found.Shown, 100.0 * found.Missed / found.Shown,
      100.0 * found.Wrong / found.Found, found.Streak);
    EXPECT_GT(found.Shown, 3000);
    EXPECT_GE(found.Near, (1.0 - 0.01 * eye.Far) * found.Shown);
    EXPECT_LE(found.Missed, 0.01 * eye.Missed * found.Shown);
    EXPECT_LE(found.Wrong, 0.01 * eye.Wrong * found.Found);
    EXPECT_LE(found.Streak, eye.Streak);
  }
}

// Every pixel has exactly one reason.
TEST_F(ScreenSpaceReflections, EveryPixelHasAReason)
{
  this->AddObjects();
  vtkNew<vtkSphereSource> bulb; // faces every direction, also the camera
  bulb->SetCenter(2.2, -1.4, 0.5);
  bulb->SetRadius(0.5);
  bulb->SetThetaResolution(64);
  bulb->SetPhiResolution(64);
  vtkActor* chrome = this->Scene.Add(bulb);
  chrome->SetProperty(this->Floor->GetProperty());
  this->Reflections->SetParameterFromText("debug-view", "reasons");
  this->LookFrom(0, -6, 2.5, false, false);
  const auto count = [this] {
    const Picture seen = Shoot(this->Scene.Window);
    std::array<int, GI_REFLECTION_ENDS> counts{};
    const auto ends = this->Ends();
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      const int reason = static_cast<int>(ends[i].z);
      EXPECT_TRUE(reason >= 0 && reason < GI_REFLECTION_ENDS);
      ++counts[reason];
      EXPECT_TRUE(seen.Depth[i] < 1.0f || reason == GI_REFLECTION_NONE) << "background reflects";
      EXPECT_EQ(reason == GI_REFLECTION_HIT, ends[i].x >= 0.0f);
    }
    return counts;
  };
  const auto counts = count();
  const char* const names[GI_REFLECTION_ENDS] = { "nothing reflects", "found", "left the screen",
    "hidden", "steps", "too rough", "toward the eye", "nothing there", "back", "too weak",
    "horizon", "ray" };
  int sum = 0;
  for (int i = 0; i < GI_REFLECTION_ENDS; ++i)
  {
    std::printf("%-18s %7d\n", names[i], counts[i]);
    sum += counts[i];
  }
  const int reflecting = sum - counts[GI_REFLECTION_NONE];
  EXPECT_EQ(sum, 401 * 303);
  for (int reason : { GI_REFLECTION_HIT, GI_REFLECTION_LEFT, GI_REFLECTION_HIDDEN,
         GI_REFLECTION_FACING, GI_REFLECTION_BACK })
  {
    EXPECT_GT(counts[reason], 0) << names[reason];
  }
  EXPECT_EQ(counts[GI_REFLECTION_STEPS] + counts[GI_REFLECTION_ROUGH] + counts[GI_REFLECTION_WEAK] +
      counts[GI_REFLECTION_RAY],
    0);

  this->Reflections->SetParameter("maximum-steps", 8);
  EXPECT_GT(count()[GI_REFLECTION_STEPS], 0);
  this->Reflections->SetParameter("maximum-steps", 256);

  this->Reflections->SetParameterFromText("fallback", "rays");
  const auto traced = count();
  // Two programs, which a compiler may round differently.
  EXPECT_NEAR(traced[GI_REFLECTION_HIT], counts[GI_REFLECTION_HIT], 1e-4 * sum);
  EXPECT_GT(traced[GI_REFLECTION_RAY], 0);
  this->Reflections->SetParameterFromText("fallback", "environment");

  this->UseMetalFloor(0.9);
  EXPECT_EQ(count()[GI_REFLECTION_ROUGH], reflecting);
  this->UseMetalFloor(0.0);
  this->Floor->GetProperty()->SetColor(0.1, 0.1, 0.1);
  this->Floor->GetProperty()->SetEdgeTint(0.1, 0.1, 0.1);
  this->Reflections->SetParameter("minimum-reflectance", 0.2);
  EXPECT_EQ(count()[GI_REFLECTION_WEAK], reflecting);
}

TEST_F(ScreenSpaceReflections, SurfacesWithoutReflectionCostNothing)
{
  this->AddObjects();
  this->LookFrom(0, -6, 2.5, false, false);
  this->Pass->CollectStatisticsOn();
  Shoot(this->Scene.Window);
  EXPECT_TRUE(this->Ran());
  this->Floor->GetProperty()->SetInterpolationToGouraud();
  this->Floor->GetProperty()->SetSpecular(0.1);
  this->Floor->GetProperty()->SetSpecularPower(20.0);
  const Picture on = Shoot(this->Scene.Window);
  EXPECT_FALSE(this->Ran());
  this->Reflections->EnabledOff();
  EXPECT_EQ(Compare(on, Shoot(this->Scene.Window), 0).Within, 1.0);
}
