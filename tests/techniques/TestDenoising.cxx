// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The filter of light that few rays found: how much noise it takes away, what it keeps, and that it ends.
 */
#include "RoomStage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
class Denoising : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ray-traced-light", Width, Height);
    this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
    this->Filter = this->Pass->GetTechnique("denoising");
    ASSERT_NE(this->Filter, nullptr);
    this->Panel = this->AddRoomWithPanel();
  }

  Values First(bool filtered)
  {
    this->Filter->SetEnabled(filtered);
    this->Pass->Restart();
    return this->After(1);
  }

  /// Expect that the filter leaves a share of the first frame's squared error, and changes the mean by less than ofMean.
  void ExpectLittleNoise(double most, double ofMean)
  {
    const Values raw = this->First(false);
    const Values filtered = this->First(true);
    this->Filter->EnabledOff();
    this->Pass->Restart();
    const Values truth = this->After(400);
    const double share = SquaredError(filtered, truth) / SquaredError(raw, truth);
    std::printf("relMSE %.4f, filtered %.4f, %.3f of it; mean %.4f of %.4f\n",
      SquaredError(raw, truth), SquaredError(filtered, truth), share, Mean(filtered), Mean(truth));
    EXPECT_LT(share, most);
    EXPECT_NEAR(Mean(filtered), Mean(truth), ofMean * Mean(truth));
  }

  /// Share of the squared error of a mean of still frames that the filter leaves. many: frames of the truth.
  double ErrorLeft(int frames, int many)
  {
    this->First(false);
    const Values raw = this->After(frames - 1);
    this->First(true);
    const Values filtered = this->After(frames - 1);
    this->Filter->EnabledOff();
    this->Pass->Restart();
    const Values truth = this->After(many);
    const double share = SquaredError(filtered, truth) / SquaredError(raw, truth);
    std::printf("after %d frames relMSE %.5f, filtered %.5f, %.3f of it\n", frames,
      SquaredError(raw, truth), SquaredError(filtered, truth), share);
    return share;
  }

  /// A floor of hills, whose slopes are a few pixels long.
  void AddFineHills()
  {
    this->AddHills(200, -0.95, 0.02, 40.0);
    this->Scene.Window->SetSize(Width / 2, Height / 2);
    this->LookFrom(0.4, 0.4, 0.3, 0.0, 0.0, -0.95);
  }

  static constexpr int Width = 160;
  static constexpr int Height = 120;
  vtkGITechnique* Filter = nullptr;
  vtkProperty* Panel = nullptr; ///< shines from the ceiling
};
}

TEST_F(Denoising, TakesMostNoiseOffTheFirstFrame)
{
  this->ExpectLittleNoise(0.1, 0.03);
}

// What the filter blurs must be noise: after some frames contacts and edges of light are sharper than neighbours' means.
TEST_F(Denoising, SparesWhatStandsOutOfTheNoise)
{
  EXPECT_LT(this->ErrorLeft(16, 400), 0.2);
}

// The more frames a mean has, the finer the shading that the filter spares: here that of slopes a few pixels long.
TEST_F(Denoising, SparesFineSlopesInTheEnd)
{
  this->AddFineHills();
  // 1.4 if the normals of neighbours could differ as much as in the first frame
  EXPECT_LT(this->ErrorLeft(64, 500), 0.8);
  this->Filter->SetParameterFromText("method", "neural");
  EXPECT_LT(this->ErrorLeft(64, 500), 0.55); // 0.58 if normals counted as without the network
}

// The filter preserves variation of light with the normal.
TEST_F(Denoising, SparesWhatNormalsExplain)
{
  this->AddFineHills();
  EXPECT_LT(this->ErrorLeft(6, 300), 0.205); // 0.227 without the regression
  this->Filter->SetParameterFromText("method", "neural");
  EXPECT_LT(this->ErrorLeft(6, 300), 0.18); // 0.278 without the regression and with looser normals
}

// Where anti-aliasing averages frames, each is filtered by the edges of their mean, which has less noise than a frame.
TEST_F(Denoising, TheMeanGuidesTheFilterOfAveragedFrames)
{
  vtkGITechnique* smooth = this->Pass->GetTechnique("anti-aliasing");
  smooth->EnabledOn();
  smooth->SetParameterFromText("mode", "accumulate");
  this->Scene.Window->SetSize(Width / 2, Height / 2);
  EXPECT_LT(this->ErrorLeft(9, 255), 0.31); // 0.33 if frames guided their own filter
  EXPECT_LT(this->ErrorLeft(33, 255), 0.9); // 1.25 if its reach fell as slowly as that of means
}

// A small change leaves most of the history, so that there is little noise; of a great one nothing stays.
TEST_F(Denoising, HistoryOfLightIsClampedWhenItChanges)
{
  this->Filter->EnabledOff();
  this->Panel->SetAmbient(0.95);
  const Values truth = this->After(400);
  this->Panel->SetAmbient(1.0);
  const Values fresh = this->First(false);
  const double noise = SquaredError(fresh, truth);
  this->After(30);
  this->Panel->SetAmbient(0.95);
  const double error = SquaredError(this->After(1), truth);
  const double before = Mean(this->After(30));
  this->Panel->SetAmbient(0.0);
  const double after = Mean(this->After(1));
  std::printf("relMSE of a frame %.4f, with the history of another light %.4f; left of light that "
              "went out %.4f\n",
    noise, error, after / before);
  EXPECT_LT(error, 0.3 * noise);
  EXPECT_LT(after, 0.05 * before);
}

TEST_F(Denoising, EndsInAStillPicture)
{
  Values early[2];
  Values late[2];
  for (const int filtered : { 0, 1 })
  {
    this->First(filtered != 0);
    early[filtered] = this->After(20);
    late[filtered] = this->After(240);
  }
  EXPECT_NE(early[0], early[1]);
  EXPECT_EQ(late[0], late[1]);
}

// Dark blue after the first frame, yellow after 64; then the filter still shows its signal, though it ends.
TEST_F(Denoising, ShowsItsSignal)
{
  const auto picture = [this](const char* show, int frames) {
    this->Filter->SetParameterFromText("show", show);
    this->Filter->EnabledOn();
    this->Pass->Restart();
    for (int i = 1; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    return Shoot(this->Scene.Window);
  };
  const auto expect = [](const Picture& shown, const std::array<int, 3>& color) {
    const auto found = shown.At(Width / 2, Height / 2);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(found[i], color[i], 2) << "channel " << i;
    }
  };
  expect(picture("frames", 1), { { 26, 13, 89 } });
  expect(picture("frames", 70), { { 255, 242, 77 } });
  expect(picture("reach", 1), { { 236, 237, 78 } }); // radius / (1 + 1 / 32)
  const Picture plain = picture("off", 1);
  const Picture raw = picture("raw", 1);
  const Picture filtered = picture("filtered", 1);
  EXPECT_LT(Compare(raw, filtered, 2).Within, 0.5);
  EXPECT_LT(Compare(plain, filtered, 2).Within, 0.9);
  // Reflections are off, so there is no signal, and the picture is as without.
  this->Filter->SetParameterFromText("signal", "reflections");
  EXPECT_EQ(Compare(plain, picture("filtered", 1), 1).Within, 1.0);
}

// Where the light is the same everywhere, nothing may be added or lost, not even at edges.
TEST_F(Denoising, KeepsEnergyAtEdges)
{
  this->ShowBlockInUniformLight();
  ExpectUniformLight(this->First(true));
}

// One wall shines, all others are black: what turns away from it stays dark.
TEST_F(Denoising, DoesNotCrossEdges)
{
  this->Scene.Renderer->RemoveAllViewProps();
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0);
  vtkActor* wall = this->AddBox(0.98, 0.99, -0.9, 0.9, -0.9, 0.9, 0.0);
  wall->GetProperty()->SetAmbient(1.0);
  this->AddBox(-0.5, 0.1, -0.3, 0.3, -0.9, 0.0, 0.8);
  this->LookFrom(-0.9, -0.8, 0.7, -0.2, 0.0, -0.4);
  this->Filter->EnabledOff();
  this->Pass->Restart();
  const Values truth = this->After(64);
  const Values filtered = this->First(true);
  double lit = 0.0;
  double dark = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const bool shines = truth[i] > 0.99;
    lit += shines ? 0.0 : truth[i];
    dark += truth[i] < 1e-6 ? filtered[i] : 0.0;
  }
  std::printf("light on dark surfaces: %.5f of all\n", dark / lit);
  EXPECT_GT(lit, 10.0);
  EXPECT_LT(dark, 1e-4 * lit);
}

// A sample beyond what half floats hold must not spoil its neighbours.
TEST_F(Denoising, TakesBrightSamples)
{
  Paint(AddFloor(this->Scene, -0.1, 0.1, -0.1, 0.1, 0.9), 0.0)
    ->GetProperty()
    ->SetAmbientColor(1e7, 1e7, 1e7);
  this->Scene.Renderer->GetActors()->GetLastActor()->GetProperty()->SetAmbient(1.0);
  const Values raw = this->First(false);
  const Values filtered = this->First(true);
  const auto bright = [](const Values& values) {
    return std::count_if(values.begin(), values.end(), [](double value) { return !(value < 3e4); });
  };
  std::printf("pixels as bright as can be: %d, filtered %d; means %g, %g\n",
    static_cast<int>(bright(raw)), static_cast<int>(bright(filtered)), Mean(raw), Mean(filtered));
  EXPECT_GT(bright(raw), 0);
  EXPECT_LE(bright(filtered), bright(raw));
}

// Without means over frames every frame is as noisy as the first, and filtered like it.
TEST_F(Denoising, DoesNotEndWithoutMeans)
{
  this->Pass->GetTechnique("temporal-accumulation")->EnabledOff();
  this->Pass->GetTechnique("anti-aliasing")->EnabledOff();
  const Values filtered = this->First(true);
  const Values later = this->After(100);
  this->Filter->EnabledOff();
  const Values raw = this->After(1);
  EXPECT_LT(SquaredError(later, filtered), 0.2 * SquaredError(raw, filtered));
}

TEST_F(Denoising, KeepsHistoryWhileTheCameraMoves)
{
  const auto error = [this](bool averaged) {
    this->Pass->GetTechnique("temporal-accumulation")->SetEnabled(averaged);
    this->First(true);
    for (int i = 0; i < 16; ++i)
    {
      this->Scene.Renderer->GetActiveCamera()->Yaw(i % 2 == 0 ? 2.0 : -2.0);
      for (const double value : this->After(1))
      {
        EXPECT_TRUE(std::isfinite(value)) << "frame " << i;
      }
    }
    return this->After(1);
  };
  const Values kept = error(true);
  const Values lost = error(false);
  this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
  this->Filter->EnabledOff();
  this->Pass->Restart();
  const Values truth = this->After(400);
  std::printf(
    "relMSE %.5f, without history %.5f\n", SquaredError(kept, truth), SquaredError(lost, truth));
  EXPECT_LT(SquaredError(kept, truth), 0.5 * SquaredError(lost, truth));
}

// Of the rays from valleys few find a slope that the camera's light reaches. Clamping would take their light away.
TEST_F(Denoising, LightOfALampAtTheEyeStaysInMotion)
{
  this->Scene.Renderer->RemoveAllViewProps();
  this->AddHills(100, 0.0, 0.15, 12.0);
  this->LookFrom(0.6, 0.5, 1.0, 0.0, 0.0, 0.0);
  this->Scene.Renderer->GetActiveCamera()->SetViewAngle(35.0);
  this->Lamp->SetLightTypeToHeadlight();
  this->Lamp->PositionalOff();
  this->Lamp->SetIntensity(1.0);
  vtkGITechnique* rays = this->Pass->GetTechnique("ray-traced-light");
  rays->EnabledOff();
  const double direct = Mean(this->After(1));
  rays->EnabledOn();
  for (const bool filtered : { false, true })
  {
    this->First(filtered);
    for (int i = 0; i < 16; ++i)
    {
      this->Scene.Renderer->GetActiveCamera()->Azimuth(i % 2 == 0 ? 2.0 : -2.0);
      this->After(1);
    }
    const Values moving = this->After(0);
    const double still = Mean(this->After(200)) - direct;
    const double share = (Mean(moving) - direct) / still;
    std::printf(
      "indirect light in motion%s: %.3f of %.4f\n", filtered ? ", filtered" : "", share, still);
    EXPECT_NEAR(share, 1.0, 0.08);
  }
}

namespace
{
/// A floor and a block under a lamp whose shadows have soft edges.
class DenoisingShadows : public Denoising
{
protected:
  void SetUp() override
  {
    Denoising::SetUp();
    this->Scene.Renderer->RemoveAllViewProps();
    this->Pass->GetTechnique("ray-traced-light")->EnabledOff();
    vtkGITechnique* shadows = this->Pass->GetTechnique("ray-traced-shadows");
    shadows->EnabledOn();
    shadows->SetParameter("samples", 1);
    shadows->SetParameter("light-radius", 0.3);
    Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.8);
    this->AddBox(-0.2, 0.1, -0.2, 0.2, 0.0, 0.5, 0.8);
    this->Lamp->SetPosition(0.8, 0.5, 1.5);
    this->Lamp->SetIntensity(1.0);
    this->LookFrom(-0.9, -1.1, 1.0, -0.2, 0.0, 0.1);
  }
};
}

TEST_F(DenoisingShadows, LoseMostNoiseInTheFirstFrame)
{
  this->ExpectLittleNoise(0.2, 0.01);
}

// Nearly along the floor, where a penumbra is few pixels high. Filtered as far as it is wide, it has 3 times the error of its
// noise.
TEST_F(DenoisingShadows, AreForeshortenedLikeTheirSurface)
{
  this->LookFrom(-0.3, -1.3, 0.25, -0.2, 0.0, 0.1);
  this->ExpectLittleNoise(0.35, 0.01);
}

TEST_F(DenoisingShadows, OfPointsStaySharp)
{
  this->Pass->GetTechnique("ray-traced-shadows")->SetParameter("light-radius", 0.0);
  EXPECT_EQ(this->First(false), this->First(true));
}

TEST_F(DenoisingShadows, EndInAStillPicture)
{
  Values late[2];
  for (const int filtered : { 0, 1 })
  {
    this->First(filtered != 0);
    late[filtered] = this->After(80);
  }
  EXPECT_EQ(late[0], late[1]);
}

// The mean over frames takes over from the filter while the camera moves, too.
TEST_F(DenoisingShadows, AreFilteredLessWithHistory)
{
  Values drawn[2];
  Values first[2];
  for (const int filtered : { 0, 1 })
  {
    first[filtered] = this->First(filtered != 0);
    for (int i = 0; i < 24; ++i)
    {
      this->Scene.Renderer->GetActiveCamera()->Yaw(i % 2 == 0 ? 0.5 : -0.5);
      drawn[filtered] = this->After(1);
    }
  }
  const double change = SquaredError(drawn[0], drawn[1]) / SquaredError(first[0], first[1]);
  std::printf("the filter changes %.5f of what it changes in the first frame\n", change);
  EXPECT_LT(change, 0.001);
}

namespace
{
/// A rough metal floor that reflects a bright block.
class DenoisingReflections : public Denoising
{
protected:
  void SetUp() override
  {
    Denoising::SetUp();
    this->Scene.Renderer->RemoveAllViewProps();
    this->Pass->GetTechnique("ray-traced-light")->EnabledOff();
    this->Reflections = this->Pass->GetTechnique("screen-space-reflections");
    this->Reflections->EnabledOn();
    this->Floor = AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0);
    this->Floor->GetProperty()->SetInterpolationToPBR();
    this->Floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    this->Floor->GetProperty()->SetMetallic(1.0);
    this->Floor->GetProperty()->SetRoughness(0.4);
    this->AddBox(-0.3, 0.0, -0.2, 0.2, 0.0, 0.5, 0.0)->GetProperty()->SetAmbient(1.0);
    this->AddBox(0.2, 0.4, 0.3, 0.6, 0.1, 0.4, 0.0)->GetProperty()->SetAmbient(0.5);
    this->LookFrom(-0.2, -1.3, 0.7, 0.0, 0.0, 0.1);
  }

  vtkGITechnique* Reflections = nullptr;
  vtkActor* Floor = nullptr;
};
}

TEST_F(DenoisingReflections, LoseMostNoiseInTheFirstFrame)
{
  this->Reflections->SetParameter("filter", false);
  const Values raw = this->First(false);
  const Values truth = this->After(400);
  this->Reflections->SetParameter("filter", true);
  const Values reused = this->First(false);
  const Values filtered = this->First(true);
  const double share = SquaredError(filtered, truth) / SquaredError(raw, truth);
  std::printf("relMSE %.4f, of rays shared %.4f, filtered %.4f, %.3f of it; mean %.4f, shared "
              "%.4f, all %.4f\n",
    SquaredError(raw, truth), SquaredError(reused, truth), SquaredError(filtered, truth), share,
    Mean(filtered), Mean(reused), Mean(truth));
  EXPECT_LT(share, 0.06);
  EXPECT_LT(SquaredError(filtered, truth), 0.6 * SquaredError(reused, truth));
  // If the neighbours that count depend on what the pixel's own ray found, 5 % are missing.
  EXPECT_NEAR(Mean(reused), Mean(truth), 0.03 * Mean(truth));
  EXPECT_NEAR(Mean(filtered), Mean(truth), 0.03 * Mean(truth));
}

TEST_F(DenoisingReflections, KeepMirrors)
{
  this->Floor->GetProperty()->SetRoughness(0.0);
  EXPECT_EQ(this->First(false), this->First(true));
}
