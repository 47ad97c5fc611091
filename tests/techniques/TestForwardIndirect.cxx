// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Indirect light on what VTK draws itself: translucent surfaces, sphere impostors and shaded volumes.
 */
#include "RoomStage.h"

#include "vtkGIDDGI.h"
#include "vtkGIPathTracing.h"
#include "vtkGIProbeBaker.h"
#include "vtkGISHProbes.h"

#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPointSource.h>
#include <vtkSphereSource.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
/// Counts how often mappers build their shaders.
class BuildCounter : public vtkOpenGLRenderPass
{
public:
  static BuildCounter* New();
  vtkTypeMacro(BuildCounter, vtkOpenGLRenderPass);
  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(
    std::string&, std::string&, std::string&, vtkAbstractMapper*, vtkProp*) override
  {
    ++this->Builds;
    return true;
  }
  void Watch(vtkProp* prop)
  {
    vtkNew<vtkInformation> keys;
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
    prop->SetPropertyKeys(keys);
  }
  int Builds = 0;

protected:
  BuildCounter() { this->ActiveDrawBuffers = 1; }
};
vtkStandardNewMacro(BuildCounter);

double FromDisplay(double value)
{
  return std::pow(value, 2.2);
}

class ForwardIndirect : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ddgi", 64, 48);
    this->Probes = vtkGIDDGI::SafeDownCast(this->Pass->GetTechnique("ddgi"));
    this->Baked = vtkGISHProbes::SafeDownCast(this->Pass->GetTechnique("sh-probes"));
    ASSERT_NE(this->Probes, nullptr);
    ASSERT_NE(this->Baked, nullptr);
    this->Probes->SetProbes(64);
  }

  /// Light from these alone; baked anew where baked ones are among them, without what may change.
  void LightBy(bool live, bool baked, vtkProp* mover = nullptr)
  {
    this->Probes->SetEnabled(live);
    this->Baked->SetEnabled(baked);
    if (baked)
    {
      const vtkSmartPointer<vtkProp> keep = mover;
      this->Scene.Renderer->RemoveViewProp(mover);
      vtkNew<vtkGIProbeBaker> baker;
      baker->SetProbes(216);
      baker->SetSamples(1024);
      vtkNew<vtkImageData> field;
      ASSERT_TRUE(baker->Bake(this->Scene.Renderer, field)) << baker->GetLastError();
      ASSERT_TRUE(this->Baked->SetBake(field)) << this->Baked->GetBakeError();
      if (mover)
      {
        this->Scene.Renderer->AddViewProp(mover);
      }
    }
  }

  /// A closed room in which everything sends out the same radiance.
  vtkActor* AddFurnace()
  {
    vtkActor* room = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5);
    room->GetProperty()->SetAmbient(0.5 * Furnace);
    this->LookFrom(0.0, -0.9, 0.0, 0.0, 0.0, 0.0);
    return room;
  }

  /// Upright, facing the eye of LookFrom(0, -y, 0, ...).
  vtkActor* AddQuad(double side, double albedo, double opacity, double x = 0.0, double y = 0.0)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-0.5 * side, 0.0, -0.5 * side);
    plane->SetPoint1(0.5 * side, 0.0, -0.5 * side);
    plane->SetPoint2(-0.5 * side, 0.0, 0.5 * side);
    vtkActor* quad = Paint(this->Scene.Add(plane), albedo);
    quad->SetPosition(x, y, 0.0);
    quad->GetProperty()->SetOpacity(opacity);
    return quad;
  }

  static void SetPBR(vtkActor* actor)
  {
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetMetallic(0.0);
    actor->GetProperty()->SetRoughness(1.0);
    actor->GetProperty()->SetBaseIOR(1.0); // no highlight
  }

  vtkSmartPointer<vtkVolume> AddVolume(double radius, bool hard)
  {
    constexpr int n = 33;
    vtkNew<vtkImageData> image;
    image->SetDimensions(n, n, n);
    const double spacing = 2.0 * radius / (n - 1);
    image->SetOrigin(-radius, -radius, -radius);
    image->SetSpacing(spacing, spacing, spacing);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double* p = image->GetPoint(i);
      const double away = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / radius;
      image->GetPointData()->GetScalars()->SetTuple1(i, hard ? 1.0 - away : 1.0);
    }
    if (!hard)
    {
      image->GetPointData()->GetScalars()->SetTuple1(0, 0.0); // a range
    }
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(image);
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSampleDistance(static_cast<float>(0.02 * radius));
    auto volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(mapper);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.1, 0.0);
    opacity->AddPoint(0.12, 1.0);
    volume->GetProperty()->SetScalarOpacity(opacity);
    volume->GetProperty()->SetScalarOpacityUnitDistance(0.01 * radius);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    volume->GetProperty()->SetColor(white);
    volume->GetProperty()->SetInterpolationTypeToLinear();
    volume->GetProperty()->ShadeOn();
    volume->GetProperty()->SetAmbient(0.0);
    volume->GetProperty()->SetDiffuse(0.9);
    volume->GetProperty()->SetSpecular(0.0);
    this->Scene.Renderer->AddVolume(volume);
    return volume;
  }

  /// The mean display value, 0 to 1, of the middle of the window, a fifth of its height wide.
  double Middle(int frames)
  {
    for (int i = 1; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    const Picture picture = Shoot(this->Scene.Window);
    const int half = picture.Height / 10;
    return picture.MeanGrey(picture.Width / 2 - half, picture.Height / 2 - half,
             picture.Width / 2 + half, picture.Height / 2 + half) /
      255.0;
  }

  static constexpr double Furnace = 0.5;
  // Frames after which DDGI's light has arrived, and after a change of a little thing.
  static constexpr int Settled = 80;
  static constexpr int Few = 4;
  vtkGIDDGI* Probes = nullptr;
  vtkGISHProbes* Baked = nullptr;
};
}

TEST_F(ForwardIndirect, TranslucentSurfacesInAFurnace)
{
  this->AddFurnace();
  constexpr double albedo = 0.9;
  constexpr double opacity = 0.6;
  // What the walls send arrives at both sides; little of it is missing for the quad.
  vtkActor* quad = this->AddQuad(0.3, albedo, opacity);
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked, quad);
    this->Middle(baked ? 1 : Settled);
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
          const double shown = this->Middle(baked ? 1 : Few);
          std::printf("%s, %s, %s, %s side: %.4f of %.4f (%+.2f %%)\n", baked ? "baked" : "DDGI",
            pbr ? "PBR" : "Phong", peeling ? "peeled" : "blended", turn > 0.0 ? "back" : "front",
            shown, expected, 100.0 * (shown / expected - 1.0));
          EXPECT_NEAR(shown / expected, 1.0, 0.03);
        }
      }
    }
  }
}

TEST_F(ForwardIndirect, LampsOfEveryKindAndNumber)
{
  this->AddFurnace();
  constexpr double albedo = 0.9;
  vtkActor* quad = this->AddQuad(0.3, albedo, 0.999);
  vtkNew<vtkLight> second;
  second->SetIntensity(0.0);
  this->Middle(Settled);
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
      const double shown = this->Middle(Few);
      const double linear = pbr ? FromDisplay(shown) : shown;
      std::printf("%s, %s: %.4f of %.4f\n", pbr ? "PBR" : "Phong", kind, linear, albedo * Furnace);
      EXPECT_NEAR(linear / (albedo * Furnace), 1.0, 0.03);
    }
  }
}

TEST_F(ForwardIndirect, NearlyOpaqueLooksAsOpaque)
{
  // A room with a lamp, walls of different colours, and a box that stands in it.
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
        const double with = this->Middle(baked ? 1 : Settled);
        this->LightBy(false, false);
        const double without = this->Middle(1);
        indirect[translucent] =
          pbr ? FromDisplay(with) - FromDisplay(without) : with - without;
      }
      std::printf("%s, %s: indirect light %.4f on the opaque quad, %.4f on the translucent one\n",
        baked ? "baked" : "DDGI", pbr ? "PBR" : "Phong", indirect[0], indirect[1]);
      EXPECT_GT(indirect[0], 0.05);
      EXPECT_NEAR(indirect[1] / indirect[0], 1.0, 0.02);
    }
  }
}

TEST_F(ForwardIndirect, TranslucentSurfacesNextDoorStayDark)
{
  this->Probes->SetProbes(512);
  this->Lamp->SetIntensity(0.5);
  this->Lamp->SetPosition(-1.2, 0.3, 0.4);
  this->AddBox(-2.0, -0.01, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(0.01, 2.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddQuad(0.4, 0.9, 0.9, -0.8);
  this->AddQuad(0.4, 0.9, 0.9, 0.8);
  this->AddQuad(0.2, 0.9, 0.9, 0.11); // its edge in reach of the wall's other side
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked);
    // Of the lamp's light, which shines through walls without shadows, nothing here.
    const auto indirect = [this](double x, double factor) {
      this->LookFrom(x, -0.9, 0.0, x, 0.0, 0.0);
      this->Probes->SetIntensity(factor);
      this->Baked->SetIntensity(factor);
      const double with = this->Middle(this->Probes->GetEnabled() ? Settled : 1);
      this->Probes->SetIntensity(0.0);
      this->Baked->SetIntensity(0.0);
      return (with - this->Middle(1)) / factor;
    };
    const double lit = indirect(-0.8, 1.0);
    for (const double x : { 0.8, 0.11 })
    {
      const double dark = indirect(x, 10.0);
      std::printf("%s: lit room %.4f, the quad at %.2f in the dark one %.5f (%.2f %%)\n",
        baked ? "baked" : "DDGI", lit, x, dark, 100.0 * dark / lit);
      EXPECT_GT(lit, 0.05);
      EXPECT_LT(dark, 0.01 * lit);
    }
  }
}

TEST_F(ForwardIndirect, SphereImpostors)
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
    const double shown = this->Middle(Settled);
    std::printf("opacity %.1f: %.4f of %.4f\n", opacity, shown, expected);
    EXPECT_NEAR(shown / expected, 1.0, 0.03);
  }
}

TEST_F(ForwardIndirect, TheFirstThatKnowsCounts)
{
  this->AddFurnace();
  vtkActor* quad = this->AddQuad(0.3, 0.9, 0.6);
  this->LightBy(true, true, quad);
  this->Baked->SetIntensity(0.1);
  const double both = this->Middle(Settled);
  this->Baked->EnabledOff();
  const double live = this->Middle(1);
  this->Probes->EnabledOff();
  this->Baked->EnabledOn();
  const double baked = this->Middle(1);
  std::printf("DDGI %.4f, baked %.4f, both %.4f\n", live, baked, both);
  EXPECT_LT(baked, 0.5 * live);
  EXPECT_NEAR(both, live, 0.004);
}

TEST_F(ForwardIndirect, ShadedVolumesInAFurnace)
{
  this->AddFurnace();
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked);
    this->Middle(baked ? 1 : Settled);
    for (const bool hard : { true, false })
    {
      auto volume = this->AddVolume(0.2, hard);
      for (const char* kind : { "positional", "directional", "headlight" })
      {
        this->Lamp->SetPositional(*kind == 'p');
        *kind == 'h' ? this->Lamp->SetLightTypeToHeadlight()
                     : this->Lamp->SetLightTypeToSceneLight();
        const double shown = this->Middle(baked ? 1 : Few);
        std::printf("%s, %s, %s: %.4f of %.4f\n", baked ? "baked" : "DDGI",
          hard ? "a surface" : "even", kind, shown, 0.9 * Furnace);
        EXPECT_NEAR(shown / (0.9 * Furnace), 1.0, 0.03);
      }
      volume->GetProperty()->ShadeOff();
      EXPECT_NEAR(this->Middle(1), 1.0, 0.01) << "as VTK draws it";
      this->Scene.Renderer->RemoveVolume(volume);
    }
  }
}

TEST_F(ForwardIndirect, ShadedVolumesAreBrightWhereLightArrives)
{
  // Light comes from a glowing wall on the left; a ball of data looks as a solid one does by the path tracer.
  this->Probes->SetProbes(512);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.3);
  this->AddBox(-0.99, -0.95, -0.9, 0.9, -0.9, 0.9, 0.0)->GetProperty()->SetAmbient(1.0);
  constexpr double radius = 0.3;
  this->Scene.Window->SetSize(80, 80);
  this->LookFrom(0.0, -0.9, 0.0, 0.0, 0.0, 0.0);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetPhiResolution(60);
  ball->SetThetaResolution(120);
  vtkSmartPointer<vtkActor> solid = Paint(this->Scene.Add(ball), 0.9);
  this->LightBy(false, false);
  auto* tracer = vtkGIPathTracing::SafeDownCast(this->Pass->GetTechnique("path-tracing"));
  tracer->EnabledOn();
  tracer->SetSamples(128);
  this->Middle(128);
  const Picture traced = Read(this->Scene.Window);
  tracer->EnabledOff();
  this->Scene.Renderer->RemoveActor(solid);
  Save(traced, "traced");
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked);
    auto volume = this->AddVolume(radius / 0.9, true);
    this->Middle(baked ? 1 : Settled);
    const Picture cloud = Read(this->Scene.Window);
    this->Scene.Renderer->RemoveVolume(volume);
    Save(cloud, baked ? "volume_baked" : "volume");
    double mean = 0.0;
    double error = 0.0;
    for (int x = 24; x < 56; ++x)
    {
      const double expected = traced.MeanGrey(x, 34, x + 1, 46);
      const double shown = cloud.MeanGrey(x, 34, x + 1, 46);
      mean += expected / 32.0;
      error += std::abs(shown - expected) / 32.0;
      if (x % 4 == 0)
      {
        std::printf("%s, column %d: %.1f of %.1f\n", baked ? "baked" : "DDGI", x, shown, expected);
      }
    }
    std::printf("%s: mean error %.1f %% of the mean\n", baked ? "baked" : "DDGI", 100.0 * error / mean);
    EXPECT_LT(error, 0.1 * mean);
    EXPECT_GT(cloud.MeanGrey(24, 34, 30, 46), 1.5 * cloud.MeanGrey(50, 34, 56, 46));
  }
}

TEST_F(ForwardIndirect, MappersKeepTheirShaders)
{
  this->AddFurnace();
  vtkNew<BuildCounter> ofSurface;
  vtkNew<BuildCounter> ofVolume;
  ofSurface->Watch(this->AddQuad(0.3, 0.9, 0.6));
  ofVolume->Watch(this->AddVolume(0.2, true));
  int changes = 0;
  for (const bool live : { false, true, false, true })
  {
    this->LightBy(live, false);
    const int before = ofSurface->Builds + ofVolume->Builds;
    this->Middle(2);
    const int surface = ofSurface->Builds;
    const int volume = ofVolume->Builds;
    changes += surface + volume > before;
    for (int i = 0; i < 5; ++i)
    {
      this->Scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      this->Middle(1);
    }
    EXPECT_EQ(ofSurface->Builds, surface) << (live ? "with" : "without") << " indirect light";
    EXPECT_EQ(ofVolume->Builds, volume) << (live ? "with" : "without") << " indirect light";
  }
  EXPECT_EQ(changes, 4) << "shaders that are built are counted";
}
