// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light of screen-space reflections: close to the path tracer's, with the environment counted once.
 */
#include "ReflectionStage.h"

#include <vtkSphereSource.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
using ReflectedLight = ReflectionStage;
}

// Where rays hit nothing on the screen, the environment's light counts once, as VTK draws it.
TEST_F(ReflectedLight, TheEnvironmentCountsOnce)
{
  this->AddEnvironment();
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 0.0, 0.5);
  ball->SetRadius(1.0);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  const vtkSmartPointer<vtkActor> kept = this->Floor; // the ball has its property
  this->Scene.Renderer->RemoveActor(this->Floor);
  vtkActor* lone = this->Scene.Add(ball);
  lone->SetProperty(this->Floor->GetProperty());
  this->UseMetalFloor(0.3);
  vtkNew<vtkLight> weak;
  weak->SetLightTypeToHeadlight();
  weak->SetIntensity(0.01);
  this->Scene.Renderer->AddLight(weak);
  this->Pass->CollectStatisticsOn();
  this->LookFrom(0, -6, 2.5, false, false);
  const Picture on = Shoot(this->Scene.Window);
  EXPECT_TRUE(this->Ran());
  this->Reflections->SetParameterFromText("fallback", "none");
  const Picture none = Shoot(this->Scene.Window);
  this->Reflections->EnabledOff();
  const Picture off = Shoot(this->Scene.Window);
  // Half floats hold the radiance to one part in two thousand.
  EXPECT_EQ(Compare(on, off, 1).Within, 1.0);
  const double lit = off.Grey(200, 150);
  std::printf("grey with the environment %.1f, without %.1f\n", lit, none.Grey(200, 150));
  EXPECT_LT(none.Grey(200, 150), 0.7 * lit);
}

// A viewport shows the same reflections as a window of its size.
TEST_F(ReflectedLight, ViewportsReflectLikeWholeWindows)
{
  this->AddObjects();
  this->Scene.Window->SetSize(200, 150);
  this->LookFrom(0, -6, 2.5, false, false);
  const Picture whole = Shoot(this->Scene.Window);
  this->Scene.Window->SetSize(400, 300);
  this->Scene.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  const Picture part = Shoot(this->Scene.Window);
  int differ = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      differ += std::abs(whole.Grey(x, y) - part.Grey(200 + x, 150 + y)) > 2.0;
    }
  }
  EXPECT_LE(differ, 30) << "of 30000 pixels; rounding of window coordinates moves a few";
}

namespace
{
// The floor's reflection against the path tracer's with one bounce. The floor has no diffuse reflection.
class GlossyFloor : public ReflectionStage
{
protected:
  void SetUp() override
  {
    ReflectionStage::SetUp();
    this->Scene.Window->SetSize(160, 120);
    this->AddObjects();
    vtkNew<vtkLight> lamp;
    lamp->SetPosition(-3.0, -5.0, 6.0);
    lamp->SetFocalPoint(0.0, 0.0, 0.0);
    this->Scene.Renderer->AddLight(lamp);
    this->Pass->GetTechnique("ray-traced-shadows")->EnabledOn();
    this->Pass->GetTechnique("ray-traced-shadows")->SetParameter("light-angle", 0.0);
    this->Pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
    this->LookFrom(0, -6, 2.5, false, false);
  }

  // Trace the reference picture and the reason of each pixel.
  void TraceReference(int samples)
  {
    vtkGITechnique* tracer = this->Pass->GetTechnique("path-tracing");
    tracer->SetParameter("bounces", 1);
    tracer->SetParameter("samples", samples);
    tracer->EnabledOn();
    this->Reference = this->Radiance(samples);
    tracer->EnabledOff();
    this->Reflections->SetParameterFromText("debug-view", "reasons");
    this->Radiance(1);
    this->Reasons = this->Ends();
    this->Reflections->SetParameterFromText("debug-view", "off");
  }

  // Error over the pixels that reflect.
  double RelMse(const std::vector<float>& picture) const
  {
    RelativeError error;
    for (std::size_t i = 0; i < this->Reasons.size(); ++i)
    {
      if (static_cast<int>(this->Reasons[i].z) == GI_REFLECTION_NONE)
      {
        continue;
      }
      for (std::size_t c = 4 * i; c < 4 * i + 3; ++c)
      {
        error.Add(picture[c], this->Reference[c]);
      }
    }
    return error.Mean();
  }

  /// Limits are on the relMSE of the first frame, of 16 frames, and of 16 frames with rays as the fallback.
  void ExpectErrors(const char* floor, int samples, const double (&limits)[3])
  {
    this->TraceReference(samples);
    this->Reflections->EnabledOff();
    const double before = this->RelMse(this->Radiance(16));
    this->Reflections->EnabledOn();
    const double first = this->RelMse(this->Radiance(1));
    const double still = this->RelMse(this->Radiance(16));
    this->Reflections->SetParameter("filter", 0.0);
    const double unfiltered = this->RelMse(this->Radiance(1));
    this->Reflections->SetParameter("filter", 1.0);
    this->Reflections->SetParameterFromText("fallback", "rays");
    const double rays = this->RelMse(this->Radiance(16));
    std::printf(
      "%-22s without %.4f; one frame %.4f, unfiltered %.4f; 16 frames %.4f, with rays %.4f\n",
      floor, before, first, unfiltered, still, rays);
    EXPECT_LT(first, limits[0]);
    EXPECT_LT(still, limits[1]);
    EXPECT_LT(rays, limits[2]);
    EXPECT_LT(first, 0.7 * before);
    EXPECT_LT(first, unfiltered);
    EXPECT_LT(rays, still);
  }

  std::vector<float> Reference;
  std::vector<glm::vec4> Reasons;
};
}

TEST_F(GlossyFloor, OfMetalApproachesThePathTracer)
{
  this->UseMetalFloor(0.25);
  this->ExpectErrors("metal, roughness 0.25", 64, { 0.154, 0.051, 0.039 });
}

TEST_F(GlossyFloor, OfRoughMetalApproachesThePathTracer)
{
  this->UseMetalFloor(0.5);
  this->ExpectErrors("metal, roughness 0.5", 64, { 0.14, 0.026, 0.019 });
}

TEST_F(GlossyFloor, OfPhongApproachesThePathTracer)
{
  this->Floor->GetProperty()->SetInterpolationToPhong();
  this->Floor->GetProperty()->SetDiffuse(0.0);
  this->Floor->GetProperty()->SetSpecular(1.0);
  this->Floor->GetProperty()->SetSpecularPower(6.0);
  this->ExpectErrors("Phong, power 6", 64, { 0.045, 0.012, 0.0066 });
}

// Temporal accumulation of the resource "reflection" averages the noise of one ray per pixel.
TEST_F(GlossyFloor, IsAccumulatedOverFrames)
{
  this->UseMetalFloor(0.5);
  this->TraceReference(64);
  this->Pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "off");
  this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
  const double first = this->RelMse(this->Radiance(1));
  const double still = this->RelMse(this->Radiance(16));
  std::printf("one frame %.4f, 16 accumulated %.4f\n", first, still);
  EXPECT_LT(still, 0.6 * first);
}
