// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Indirect light on translucent surfaces and sphere impostors.
 */
#include "ForwardStage.h"

#include <vtkOpenGLSphereMapper.h>
#include <vtkPointSource.h>

#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
using ForwardIndirect = ForwardStage;

double FromDisplay(double value)
{
  return std::pow(value, 2.2);
}
}

TEST_F(ForwardIndirect, TranslucentSurfacesReceiveTheLightOfAFurnace)
{
  this->AddFurnace();
  constexpr double albedo = 0.9;
  constexpr double opacity = 0.6;
  // The light of the walls reaches both sides of the quad, which itself blocks little of it.
  vtkActor* quad = this->AddQuad(0.3, albedo, opacity);
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked, quad);
    this->DisplayValue(baked ? 1 : FramesToConverge);
    for (const bool pbr : { false, true })
    {
      if (pbr)
      {
        SetPBR(quad);
      }
      else
      {
        quad->GetProperty()->SetInterpolationToFlat();
      }
      const double lit = albedo * Furnace;
      const double expected =
        opacity * (pbr ? std::pow(lit, 1.0 / 2.2) : lit) + (1.0 - opacity) * Furnace;
      for (const bool peeling : { false, true })
      {
        this->Scene.Window->SetAlphaBitPlanes(1);
        this->Scene.Renderer->SetUseDepthPeeling(peeling);
        for (const double turn : { 0.0, 180.0 })
        {
          quad->SetOrientation(0.0, 0.0, turn);
          const double shown = this->DisplayValue(baked ? 1 : FramesToAdjust);
          std::printf("%s, %s, %s, %s side: %.4f of %.4f (%+.2f %%)\n", baked ? "baked" : "DDGI",
            pbr ? "PBR" : "Phong", peeling ? "peeled" : "blended", turn > 0.0 ? "back" : "front",
            shown, expected, 100.0 * (shown / expected - 1.0));
          EXPECT_NEAR(shown / expected, 1.0, baked ? 0.006 : 0.0045);
        }
      }
    }
  }
}

TEST_F(ForwardIndirect, IndirectLightDoesNotDependOnTheKindOfLamp)
{
  this->AddFurnace();
  constexpr double albedo = 0.9;
  vtkActor* quad = this->AddQuad(0.3, albedo, 0.999);
  vtkNew<vtkLight> second;
  second->SetIntensity(0.0);
  this->DisplayValue(FramesToConverge);
  for (const bool pbr : { false, true })
  {
    if (pbr)
    {
      SetPBR(quad);
    }
    for (const char* kind : { "positional", "directional", "headlight", "two" })
    {
      this->Lamp->SetPositional(*kind == 'p');
      *kind == 'h' ? this->Lamp->SetLightTypeToHeadlight() : this->Lamp->SetLightTypeToSceneLight();
      this->Scene.Renderer->RemoveLight(second);
      if (*kind == 't')
      {
        this->Scene.Renderer->AddLight(second);
      }
      const double shown = this->DisplayValue(FramesToAdjust);
      const double linear = pbr ? FromDisplay(shown) : shown;
      std::printf("%s, %s: %.4f of %.4f\n", pbr ? "PBR" : "Phong", kind, linear, albedo * Furnace);
      EXPECT_NEAR(linear / (albedo * Furnace), 1.0, 0.03);
    }
  }
}

TEST_F(ForwardIndirect, NearlyOpaqueSurfacesMatchOpaqueOnes)
{
  // A room with a lamp, walls of different colours and a box.
  this->Probes->SetProbes(216);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.98, -0.9, -1.0, 1.0, -1.0, 1.0, 0.7)->GetProperty()->SetColor(1.0, 0.1, 0.1);
  this->AddBox(-0.8, -0.3, 0.2, 0.7, -1.0, 0.2, 0.7);
  this->Lamp->SetPosition(0.0, 0.0, 0.8);
  this->Lamp->SetIntensity(0.5);
  this->LookFrom(0.0, -0.9, 0.0, 0.0, 0.0, 0.0);
  vtkActor* quad = this->AddQuad(0.4, 0.9, 1.0);
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked, quad);
    for (const bool pbr : { false, true })
    {
      if (pbr)
      {
        SetPBR(quad);
      }
      else
      {
        quad->GetProperty()->SetInterpolationToFlat();
      }
      double indirect[2];
      for (const bool translucent : { false, true })
      {
        quad->GetProperty()->SetOpacity(translucent ? 0.999 : 1.0);
        (baked ? static_cast<vtkGITechnique*>(this->Baked) : this->Probes)->EnabledOn();
        const double with = this->DisplayValue(baked ? 1 : FramesToConverge);
        this->LightBy(false, false);
        const double without = this->DisplayValue(1);
        indirect[translucent] = pbr ? FromDisplay(with) - FromDisplay(without) : with - without;
      }
      std::printf("%s, %s: indirect light %.4f on the opaque quad, %.4f on the translucent one\n",
        baked ? "baked" : "DDGI", pbr ? "PBR" : "Phong", indirect[0], indirect[1]);
      EXPECT_GT(indirect[0], 0.05);
      EXPECT_NEAR(indirect[1] / indirect[0], 1.0, 0.003);
    }
  }
}

TEST_F(ForwardIndirect, TranslucentSurfacesNextDoorStayDark)
{
  this->Probes->SetProbes(512);
  this->Lamp->SetIntensity(0.5);
  this->AddTwoRooms(0.02);
  this->AddQuad(0.4, 0.9, 0.9, -0.8);
  this->AddQuad(0.4, 0.9, 0.9, 0.8);
  this->AddQuad(0.2, 0.9, 0.9, 0.11); // its edge is within reach of the probes behind the wall
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked);
    // The difference leaves out the lamp's own light, which passes through walls without shadow maps.
    const auto indirect = [this](double x, double factor) {
      this->LookFrom(x, -0.9, 0.0, x, 0.0, 0.0);
      this->Probes->SetIntensity(factor);
      this->Baked->SetIntensity(factor);
      const double with = this->DisplayValue(this->Probes->GetEnabled() ? FramesToConverge : 1);
      this->Probes->SetIntensity(0.0);
      this->Baked->SetIntensity(0.0);
      return (with - this->DisplayValue(1)) / factor;
    };
    const double lit = indirect(-0.8, 1.0);
    for (const double x : { 0.8, 0.11 })
    {
      const double dark = indirect(x, 10.0);
      std::printf("%s: lit room %.4f, the quad at %.2f in the dark one %.5f (%.2f %%)\n",
        baked ? "baked" : "DDGI", lit, x, dark, 100.0 * dark / lit);
      EXPECT_GT(lit, 0.05);
      EXPECT_LT(dark, 1.5e-4 * lit);
    }
  }
}

TEST_F(ForwardIndirect, SphereImpostorsReceiveTheLightOfAFurnace)
{
  this->AddFurnace();
  constexpr double albedo = 0.9;
  vtkNew<vtkPointSource> point;
  point->SetNumberOfPoints(1);
  point->SetRadius(0.0);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputConnection(point->GetOutputPort());
  mapper->SetRadius(0.2f);
  vtkActor* ball = Paint(this->Scene.Add(mapper), albedo);
  for (const double opacity : { 1.0, 0.6 })
  {
    ball->GetProperty()->SetOpacity(opacity);
    const double expected = opacity * albedo * Furnace + (1.0 - opacity) * Furnace;
    const double shown = this->DisplayValue(FramesToConverge);
    std::printf("opacity %.1f: %.4f of %.4f\n", opacity, shown, expected);
    EXPECT_NEAR(shown / expected, 1.0, 0.03);
  }
}

TEST_F(ForwardIndirect, LiveProbesTakePrecedenceOverBakedOnes)
{
  this->AddFurnace();
  vtkActor* quad = this->AddQuad(0.3, 0.9, 0.6);
  this->LightBy(true, true, quad);
  this->Baked->SetIntensity(0.1);
  const double both = this->DisplayValue(FramesToConverge);
  this->Baked->EnabledOff();
  const double live = this->DisplayValue(1);
  this->Probes->EnabledOff();
  this->Baked->EnabledOn();
  const double baked = this->DisplayValue(1);
  std::printf("DDGI %.4f, baked %.4f, both %.4f\n", live, baked, both);
  EXPECT_LT(baked, 0.5 * live);
  EXPECT_NEAR(both, live, 0.004);
}
