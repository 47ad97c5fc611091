// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whole scenes lit by rays from each pixel and probes where they end, against the path tracer: lamps next door and out
 * of sight, an emitter that moves, a texture that glows, a sky with a sun, a closed room, and many and broken emitters.
 */
#include "RoomStage.h"

#include <cstdio>
#include <limits>
#include <string>

using namespace penumbra_test;

namespace
{
class RayTracedScenes : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ray-traced-light", Width, Height);
    this->SwitchOn();
  }

  /// Switch on what is tested, with the probes of the preset high. Lamps get the shadows that paths give them.
  void SwitchOn()
  {
    for (const char* name :
      { "ray-traced-light", "temporal-accumulation", "ddgi", "ray-traced-shadows" })
    {
      this->Pass->GetTechnique(name)->EnabledOn();
    }
    this->Pass->GetTechnique("ddgi")->SetParameter("rays", 64);
    this->Pass->GetTechnique("ddgi")->SetParameter("updates", 32);
    this->Pass->KeepRadianceOn();
  }

  /// Replace the pass by one that has drawn nothing yet.
  void BeginAfresh()
  {
    this->Pass->ReleaseGraphicsResources(this->Scene.Window);
    this->Pass = this->Scene.SetPasses().front();
    this->SwitchOn();
  }

  /// Add a black rectangle that emits light from both sides.
  vtkActor* AddPanel(
    const Point& origin, const Point& firstCorner, const Point& secondCorner, double radiance)
  {
    vtkActor* panel = Paint(AddQuad(this->Scene, origin, firstCorner, secondCorner), 0.0);
    panel->GetProperty()->SetAmbient(1.0); // VTK allows no more
    panel->GetProperty()->SetAmbientColor(radiance, radiance, radiance);
    return panel;
  }

  /// Set an environment that shines half as much from below, with a sun of 0.03 steradians.
  void SetSky(double radiance, double ofSun)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(64, 32, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    for (int i = 0; i < 64 * 32; ++i)
    {
      const bool isSun = i % 64 / 2 == 20 && i / 64 / 2 == 12;
      for (int c = 0; c < 3; ++c)
      {
        image->SetScalarComponentFromDouble(
          i % 64, i / 64, 0, c, isSun ? ofSun : (i / 64 < 16 ? 0.5 : 1.0) * radiance);
      }
    }
    ShineFrom(this->Scene.Renderer, EnvironmentTexture(image));
  }

  Values Drawn(int frames = 64)
  {
    Values values = this->After(frames);
    this->Check("drawn");
    return values;
  }

  Values Traced(int paths = 256)
  {
    this->Pass->SetPreset("reference");
    this->Pass->GetTechnique("path-tracing")->SetParameter("samples", paths);
    // Probes know all bounces; the default, 8, leaves out a few percent of a room's light.
    this->Pass->GetTechnique("path-tracing")->SetParameter("bounces", 64);
    this->Pass->KeepRadianceOn();
    Values values = this->After(paths);
    this->Check("traced");
    return values;
  }

  void Check(const char* what)
  {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    Save(Read(this->Scene.Window), std::string(test->name()) + "-" + what);
    EXPECT_STREQ(this->Pass->GetLastError(), "");
    EXPECT_TRUE(TakeMessages().empty());
  }

  /// Means of squares of six by six pixels. In them the noise of paths hardly counts, and neither does that paths show
  /// smooth edges.
  static Values Coarse(const Values& values, int width)
  {
    Values coarse(values.size() / 36, 0.0);
    for (int i = 0; i < static_cast<int>(values.size()); ++i)
    {
      coarse[i / width / 6 * (width / 6) + i % width / 6] += values[i] / 36.0;
    }
    return coarse;
  }

  /// Expect a relative squared error of coarse pixels below a limit, and a mean within a share of the true one.
  void ExpectNear(
    const char* what, const Values& values, const Values& truth, double limit, double ofMean)
  {
    ASSERT_EQ(values.size(), truth.size());
    const int width = this->Scene.Window->GetSize()[0];
    const double error = RelativeSquaredError(Coarse(values, width), Coarse(truth, width));
    const double mean = Mean(truth);
    std::printf("%s: relMSE %.6f (of single pixels %.5f), mean %.5f of %.5f, %+.2f %%\n", what,
      error, RelativeSquaredError(values, truth), Mean(values), mean,
      100.0 * (Mean(values) / mean - 1.0));
    EXPECT_GT(mean, 0.005) << what;
    EXPECT_LT(error, limit) << what;
    EXPECT_NEAR(Mean(values), mean, ofMean * mean) << what;
  }

  /// Add a closed room on a floor, with a lamp, a panel and the sky outside.
  void AddClosedRoom(double thickness)
  {
    this->SetSky(0.5, 300.0);
    Paint(AddFloor(this->Scene, -3.0, 3.0, -3.0, 3.0, -1.2), 0.7);
    this->AddPanel({ 1.3, -0.8, -0.8 }, { 1.3, 0.8, -0.8 }, { 1.3, -0.8, 0.8 }, 3.0);
    this->Lamp->SetPosition(0.5, 2.5, 1.5);
    this->Lamp->SetIntensity(1.0);
    this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
    if (thickness > 0.0)
    {
      const double far = 1.0 + thickness;
      this->AddBox(-far, far, -far, far, -far, far, 0.7);
    }
  }

  /// Expect that the closed room holds at most a thousandth of the light outside.
  void ExpectDarkness()
  {
    this->LookFrom(2.5, 2.0, 1.5, 0.0, 0.0, 0.0);
    const double lit = Mean(this->Drawn(16));
    EXPECT_GT(lit, 0.3);
    for (const double side : { -1.0, 1.0 })
    {
      this->LookFrom(0.8 * side, 0.7, 0.6, -0.6 * side, -0.6, -0.5);
      const double dark = Mean(this->Drawn(16));
      std::printf("inside %.6f, outside %.4f, %.4f %%\n", dark, lit, 100.0 * dark / lit);
      EXPECT_LT(dark, 1e-3 * lit) << "side: " << side;
    }
  }

  static constexpr int Width = 96;
  static constexpr int Height = 72;
};
}

// All light in the picture was reflected next door and came through the doorway, so it has the error of the probes' cells:
// +3.3 % with these, +7.2 % with the default, 1024 probes. Most of the relative squared error, 0.0029, is noise of the paths.
TEST_F(RayTracedScenes, LampInTheNextRoom)
{
  this->AddBox(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.05, 0.05, -1.0, -0.3, -1.0, 1.0, 0.7);
  this->AddBox(-0.05, 0.05, 0.3, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.05, 0.05, -0.3, 0.3, 0.4, 1.0, 0.7);
  this->Lamp->SetPosition(-0.25, 0.85, 0.4);
  this->Lamp->SetIntensity(3.0);
  this->Pass->GetTechnique("ddgi")->SetParameter("probes", 6000);
  this->LookFrom(0.2, 0.9, 0.7, 1.9, 0.5, -0.4);
  const Values drawn = this->Drawn();
  this->ExpectNear("next door", drawn, this->Traced(), 0.0045, 0.045);
}

// A lamp lights one side of each gap, and what is below sees little else than the gap's sides. If rays asked probes wherever they
// end, the mean would be 3.1 % too dark, and the relative squared error 0.0046 instead of 0.0020.
TEST_F(RayTracedScenes, GapsNarrowerThanACell)
{
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0, -0.4), 0.8);
  for (double x = -0.9; x < 1.0; x += 0.18)
  {
    this->AddBox(x, x + 0.1, -1.0, 1.0, -0.4, 0.0, 0.8);
  }
  this->Lamp->SetPosition(1.5, 0.0, 1.5);
  this->Lamp->SetIntensity(1.0);
  this->Pass->GetTechnique("ddgi")->SetParameter("probes", 125);
  this->LookFrom(-0.1, -0.5, 0.5, -0.1, 0.0, -0.2);
  const Values drawn = this->Drawn();
  this->ExpectNear("in gaps", drawn, this->Traced(), 0.003, 0.02);
}

// Relative squared error 0.0001; filtered 0.0002. With 1024 probes the mean is 0.6 % too bright.
TEST_F(RayTracedScenes, LampAndPanelBehindTheCamera)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.8, -0.3, -0.4, 0.1, -1.0, 0.0, 0.6);
  this->AddPanel({ 0.9, -0.5, -0.6 }, { 0.9, 0.1, -0.6 }, { 0.9, -0.5, 0.2 }, 2.0);
  this->Lamp->SetPosition(0.8, 0.7, 0.5);
  this->Lamp->SetIntensity(0.3);
  this->Pass->GetTechnique("ddgi")->SetParameter("probes", 3000);
  this->LookFrom(0.5, 0.2, 0.2, -0.5, -0.2, -0.3);
  const Values drawn = this->Drawn();
  // After few frames the probes still lack bounces.
  this->Pass->GetTechnique("denoising")->EnabledOn();
  this->Pass->Restart();
  const Values filtered = this->Drawn(8);
  const Values truth = this->Traced();
  this->ExpectNear("behind the camera", drawn, truth, 0.00018, 0.006);
  this->ExpectNear("after eight frames, filtered", filtered, truth, 0.0004, 0.015);
}

// Relative squared errors 0.0005, 0.0006 and 0.0006, mostly noise; +0.8 %, +1.2 % and +0.3 %.
TEST_F(RayTracedScenes, EmitterThatMovedLeavesNoGhost)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5);
  this->AddBox(-0.2, 0.2, -0.6, -0.2, -1.0, -0.4, 0.5);
  vtkActor* panel =
    this->AddPanel({ -0.1, -0.1, 0.7 }, { 0.1, -0.1, 0.7 }, { -0.1, 0.1, 0.7 }, 40.0);
  this->LookFrom(0.0, 0.9, 0.3, 0.0, -0.6, -0.6);
  panel->SetPosition(-0.7, 0.0, 0.0);
  this->After(64); // a long history
  for (int i = 1; i <= 12; ++i)
  {
    panel->SetPosition(-0.7 + 1.4 * i / 12.0, 0.0, 0.0);
    this->After(1);
  }
  const Values moved = this->Drawn();
  this->BeginAfresh();
  const Values fresh = this->Drawn();
  const Values truth = this->Traced();
  this->ExpectNear("fresh", fresh, truth, 0.0009, 0.015);
  this->ExpectNear("moved", moved, truth, 0.001, 0.018);
  this->ExpectNear("moved against fresh", moved, fresh, 0.001, 0.005);
}

// Relative squared error 0.0004, +1.3 %.
TEST_F(RayTracedScenes, TextureThatGlows)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 64 * 2; ++i)
  {
    const bool bright = i % 64 < 32;
    image->SetScalarComponentFromDouble(i % 64, i / 64, 0, 0, bright ? 255.0 : 20.0);
    image->SetScalarComponentFromDouble(i % 64, i / 64, 0, 1, bright ? 200.0 : 20.0);
    image->SetScalarComponentFromDouble(i % 64, i / 64, 0, 2, bright ? 120.0 : 80.0);
  }
  auto texture = EnvironmentTexture(image);
  texture->MipmapOff();
  texture->UseSRGBColorSpaceOn(); // VTK demands it of textures that glow
  vtkProperty* property =
    AddQuad(this->Scene, { -0.5, -0.6, 0.4 }, { 0.5, -0.6, 0.4 }, { -0.5, -0.3, 0.7 })
      ->GetProperty();
  property->SetInterpolationToPBR();
  property->SetColor(0.0, 0.0, 0.0);
  property->SetRoughness(1.0);
  property->SetEmissiveTexture(texture);
  property->SetEmissiveFactor(3.0, 3.0, 3.0);
  this->LookFrom(0.0, 0.9, 0.6, 0.0, -0.2, -0.6);
  const Values drawn = this->Drawn();
  this->ExpectNear("texture", drawn, this->Traced(), 0.0006, 0.015);
}

// Relative squared error 0.0010, -0.3 %. Most of it is in the shadow: where it is darkest, beside the box, it is up to
// a quarter too bright, as only probes know the sun where rays end.
TEST_F(RayTracedScenes, SkyWithASmallSun)
{
  this->SetSky(0.3, 300.0);
  Paint(AddFloor(this->Scene, -3.0, 3.0, -3.0, 3.0), 0.7);
  this->AddBox(-0.4, 0.4, -0.4, 0.4, 0.0, 0.8, 0.6);
  this->LookFrom(1.0, 0.9, 1.6, 0.0, 0.0, 0.2);
  const Values drawn = this->Drawn();
  this->ExpectNear("sky", drawn, this->Traced(), 0.0016, 0.006);
}

// No light at all.
TEST_F(RayTracedScenes, NothingLeaksThroughThickWalls)
{
  this->AddClosedRoom(0.1);
  this->ExpectDarkness();
}

TEST_F(RayTracedScenes, NothingLeaksThroughWallsOfOneSheet)
{
  this->AddClosedRoom(0.0);
  this->ExpectDarkness();
  this->Pass->GetTechnique("sky-light")->EnabledOn();
  this->ExpectDarkness();
}

// A small lamp near the floor among many that are far above: rays must find it by its distance, or it is all noise.
TEST_F(RayTracedScenes, ANearEmitterAmongManyIsFound)
{
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.8);
  this->LookFrom(0.0, -0.9, 0.5, 0.0, 0.0, 0.0);
  vtkNew<vtkPlaneSource> many;
  many->SetOrigin(-4.0, -4.0, 6.0);
  many->SetPoint1(4.0, -4.0, 6.0);
  many->SetPoint2(-4.0, 4.0, 6.0);
  many->SetResolution(64, 64);
  Paint(this->Scene.Add(many), 0.0)->GetProperty()->SetAmbient(0.05);
  this->AddPanel({ -0.02, -0.02, 0.1 }, { 0.02, -0.02, 0.1 }, { -0.02, 0.02, 0.1 }, 20.0);
  this->Pass->GetTechnique("ddgi")->EnabledOff();
  const Values first = this->After(4);
  const Values truth = this->After(400);
  const double error = RelativeSquaredError(first, truth);
  std::printf("relMSE after four frames %.4f\n", error);
  EXPECT_LT(error, 0.04);
}

TEST_F(RayTracedScenes, AMillionTrianglesShineAsOneSquare)
{
  this->Scene.Window->SetSize(48, 36);
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.8);
  this->LookFrom(0.0, -0.01, 0.55, 0.0, 0.0, 0.0);
  vtkActor* square =
    this->AddPanel({ -0.3, -0.3, 1.0 }, { 0.3, -0.3, 1.0 }, { -0.3, 0.3, 1.0 }, 1.0);
  const Values expected = this->Drawn();
  square->VisibilityOff();
  this->AddPanel({ -0.9, -0.4, 0.6 }, { -0.5, -0.4, 0.6 }, { -0.9, 0.4, 0.6 }, 1.0)
    ->SetScale(0.0, 1.0, 1.0); // without area
  vtkNew<vtkPlaneSource> fine;
  fine->SetOrigin(-0.3, -0.3, 1.0);
  fine->SetPoint1(0.3, -0.3, 1.0);
  fine->SetPoint2(-0.3, 0.3, 1.0);
  fine->SetResolution(707, 707);
  Paint(this->Scene.Add(fine), 0.0)->GetProperty()->SetAmbient(1.0);
  this->BeginAfresh();
  this->ExpectNear("a million triangles", this->Drawn(), expected, 0.00005, 0.002);
}

// An emitter whose colour is not a number counts as black, and takes no light from others.
TEST_F(RayTracedScenes, BrokenColoursCountAsBlack)
{
  this->Scene.Window->SetSize(48, 36);
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.8);
  this->LookFrom(0.0, -0.01, 0.55, 0.0, 0.0, 0.0);
  this->AddPanel({ -0.3, -0.3, 1.0 }, { 0.3, -0.3, 1.0 }, { -0.3, 0.3, 1.0 }, 1.0);
  vtkActor* broken = this->AddPanel({ 0.5, -0.4, 0.6 }, { 0.9, -0.4, 0.6 }, { 0.5, 0.4, 0.6 }, 0.0);
  const Values expected = this->Drawn();
  broken->GetProperty()->SetAmbientColor(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0);
  this->BeginAfresh();
  const Values drawn = this->Drawn();
  for (const double value : drawn)
  {
    ASSERT_TRUE(std::isfinite(value));
  }
  this->ExpectNear("broken", drawn, expected, 0.0001, 0.005);
}
