// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Indirect light in shaded volumes, and how often mappers build their shaders.
 */
#include "ForwardStage.h"
#include "WhiteVolume.h"

#include "vtkGIPathTracing.h"

#include "gpu/ShaderLibrary.h"

#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkSphereSource.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <unistd.h>

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

class ForwardVolumes : public ForwardStage
{
protected:
  // A ball with a surface, or a uniform cube.
  vtkSmartPointer<vtkVolume> AddVolume(double radius, bool ball)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.1, 0.0);
    opacity->AddPoint(0.12, 1.0);
    // The corners of the cube differ, so that its scalars have a range.
    const auto value = [ball](double distance) {
      return ball ? 1.0 - distance : distance > 1.73 ? 0.0 : 1.0;
    };
    auto volume = WhiteVolume(radius, value, opacity);
    this->Scene.Renderer->AddVolume(volume);
    return volume;
  }
};
}

TEST_F(ForwardVolumes, ShadedVolumesReceiveTheLightOfAFurnace)
{
  this->AddFurnace();
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked);
    this->DisplayValue(baked ? 1 : FramesToConverge);
    for (const bool ball : { true, false })
    {
      auto volume = this->AddVolume(0.2, ball);
      for (const char* kind : { "positional", "directional", "headlight" })
      {
        this->Lamp->SetPositional(*kind == 'p');
        *kind == 'h' ? this->Lamp->SetLightTypeToHeadlight()
                     : this->Lamp->SetLightTypeToSceneLight();
        const double shown = this->DisplayValue(baked ? 1 : FramesToAdjust);
        std::printf("%s, %s, %s: %.4f of %.4f\n", baked ? "baked" : "DDGI", ball ? "ball" : "cube",
          kind, shown, 0.9 * Furnace);
        EXPECT_NEAR(shown / (0.9 * Furnace), 1.0, 0.0045);
      }
      volume->GetProperty()->ShadeOff();
      EXPECT_NEAR(this->DisplayValue(1), 1.0, 0.01) << "as VTK draws it";
      this->Scene.Renderer->RemoveVolume(volume);
    }
  }
}

TEST_F(ForwardVolumes, ShadedVolumesMatchThePathTracersBall)
{
  // A glowing wall on the left lights a volume of a ball, which must look like a solid ball in the path tracer.
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
  this->DisplayValue(128);
  const Picture traced = Read(this->Scene.Window);
  tracer->EnabledOff();
  this->Scene.Renderer->RemoveActor(solid);
  Save(traced, "traced");
  for (const bool baked : { false, true })
  {
    this->LightBy(!baked, baked);
    auto volume = this->AddVolume(radius / 0.9, true);
    this->DisplayValue(baked ? 1 : FramesToConverge);
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
    std::printf(
      "%s: mean error %.1f %% of the mean\n", baked ? "baked" : "DDGI", 100.0 * error / mean);
    EXPECT_LT(error, (baked ? 0.09 : 0.1) * mean);
    EXPECT_GT(cloud.MeanGrey(24, 34, 30, 46), 1.5 * cloud.MeanGrey(50, 34, 56, 46));
  }
}

// A sample looks up its probes only after the ray has advanced an eighth of a cell. A replaced shader draws the samples
// that look up white and the others black; another one draws all of them white.
TEST_F(ForwardVolumes, FewSamplesLookUpTheProbes)
{
  this->AddFurnace();
  auto volume = this->AddVolume(0.35, true);
  vtkNew<vtkPiecewiseFunction> faint;
  faint->AddPoint(0.0, 0.0);
  faint->AddPoint(1.0, 0.05);
  volume->GetProperty()->SetScalarOpacity(faint);
  volume->GetProperty()->SetDiffuse(1.0);
  const std::string folder =
    testing::TempDir() + "penumbra_volume_shaders_" + std::to_string(getpid());
  const std::string file = folder + "/forward/volume.glsl";
  std::filesystem::create_directories(folder + "/forward");
  const std::string begin = "vec3 giScattered(", lookUp = "giCubeKnown = true;";
  const std::string text = penumbra::EmbeddedShaders().at("forward/volume.glsl");
  ASSERT_NE(text.find(begin), std::string::npos);
  ASSERT_NE(text.find(lookUp), std::string::npos);
  const auto shown = [&](const std::string& result, vtkGITechnique* light) {
    std::string changed = text;
    changed.replace(changed.find(lookUp), lookUp.size(), lookUp + " lookedUp = 1.0;");
    changed.replace(changed.find(begin), begin.size(), "float lookedUp;\nvec3 giLight(");
    std::ofstream(file)
      << changed
      << "vec3 giScattered(vec4 place, vec4 gradient, mat4 textureToEye, vec3 spacing)\n"
         "{\n  lookedUp = 0.0;\n  vec3 light = giLight(place, gradient, textureToEye, spacing);\n"
         "  return light * 1e-9 + vec3("
      << result << ");\n}\n";
    this->Pass->SetShaderPath("");
    this->Pass->SetShaderPath(folder.c_str());
    light->EnabledOff();
    this->DisplayValue(1); // the mapper builds its shader again when the light is back
    light->EnabledOn();
    return this->DisplayValue(2);
  };
  for (const bool live : { true, false })
  {
    this->LightBy(live, !live, volume);
    vtkGITechnique* light = live ? static_cast<vtkGITechnique*>(this->Probes) : this->Baked;
    const double share = shown("lookedUp", light) / shown("1.0", light);
    std::printf(
      "%s: one of %.1f samples looks up the probes\n", live ? "DDGI" : "baked", 1.0 / share);
    EXPECT_LT(share, live ? 1.0 / 12.0 : 1.0 / 6.5);
    EXPECT_GT(share, 0.02);
  }
  this->Pass->SetShaderPath("");
  std::filesystem::remove_all(folder);
}

// The share of the lights that is ambient, on opaque and translucent surfaces and on volumes.
TEST_F(ForwardVolumes, TheAmbientShareReachesSurfacesAndVolumes)
{
  this->LightBy(false, false);
  this->LookFrom(0.0, -0.9, 0.0, 0.0, 0.0, 0.0);
  this->Lamp->PositionalOff();
  this->Lamp->SetPosition(0.0, -1.0, 1.0);
  this->Lamp->SetIntensity(0.8);
  auto* occlusion = this->Pass->GetTechnique("ambient-occlusion");
  occlusion->EnabledOn();
  vtkActor* quad = this->AddQuad(0.4, 0.9, 1.0);
  for (const bool shadows : { false, true })
  {
    this->Pass->GetTechnique("shadow-maps")->SetEnabled(shadows);
    for (const double share : { 1.0, 0.3 })
    {
      occlusion->SetParameter("ambient-share", share);
      quad->VisibilityOn();
      for (const bool pbr : { false, true })
      {
        pbr ? SetPBR(quad) : quad->GetProperty()->SetInterpolationToFlat();
        quad->GetProperty()->SetOpacity(1.0);
        const double opaque = this->DisplayValue(1);
        quad->GetProperty()->SetOpacity(0.999);
        const double translucent = this->DisplayValue(1);
        std::printf("share %.1f, %s: opaque %.4f, translucent %.4f\n", share, pbr ? "PBR" : "Phong",
          opaque, translucent);
        EXPECT_GT(opaque, 0.2);
        EXPECT_NEAR(translucent / opaque, 1.0, 0.02);
      }
      quad->VisibilityOff();
      auto volume = this->AddVolume(0.2, true);
      this->Lamp->SetPosition(1.0, 0.0, 0.0); // mean cosine of the middle toward it: 0.26
      const double aside = this->DisplayValue(1);
      this->Lamp->SetPosition(0.0, -1.0, 1.0);
      const double expected = 0.9 * 0.8 * (share + 0.26 * (1.0 - share));
      std::printf("share %.1f: volume beside the lamp %.4f of %.4f\n", share, aside, expected);
      EXPECT_NEAR(aside, expected, 0.02);
      this->Scene.Renderer->RemoveVolume(volume);
    }
  }
}

// VTK keeps the noise that jitters a volume's samples bound to its texture unit until the window's frame ends.
TEST_F(ForwardVolumes, JitteredVolumesMayBeDrawnTwiceInAFrame)
{
  this->AddFurnace();
  this->Lamp->SetPosition(0.0, -0.6, 0.6);
  this->Lamp->SetIntensity(0.5);
  auto volume = this->AddVolume(0.3, true);
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  mapper->UseJitteringOn();
  mapper->SetSampleDistance(0.05f); // so that it shows
  this->Pass->GetTechnique("shadow-maps")->EnabledOn();
  this->Probes->SetUpdates(1);
  this->LightBy(true, false);
  this->DisplayValue(FramesToAdjust);
  const Picture once = Read(this->Scene.Window);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(this->Pass);
  passes->AddItem(this->Pass);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  this->Scene.Renderer->SetPass(sequence);
  this->DisplayValue(1);
  const Picture twice = Read(this->Scene.Window);
  this->Scene.Renderer->SetPass(this->Pass);
  Save(once, "jittered_once");
  Save(twice, "jittered_twice");
  int most = 0; // within the volume: the noise of shadows on walls differs from frame to frame
  for (int y = 17; y < 31; ++y)
  {
    for (int x = 25; x < 39; ++x)
    {
      most = std::max(most, std::abs(once.At(x, y)[1] - twice.At(x, y)[1]));
    }
  }
  std::printf("once and twice differ by %d of 255 at most\n", most);
  EXPECT_LE(most, 1);
}

TEST_F(ForwardVolumes, MappersRebuildShadersOnlyWhenLightIsSwitched)
{
  this->AddFurnace();
  vtkNew<BuildCounter> surfaceShaders;
  vtkNew<BuildCounter> volumeShaders;
  surfaceShaders->Watch(this->AddQuad(0.3, 0.9, 0.6));
  volumeShaders->Watch(this->AddVolume(0.2, true));
  int changes = 0;
  for (const bool live : { false, true, false, true })
  {
    this->LightBy(live, false);
    const int before = surfaceShaders->Builds + volumeShaders->Builds;
    this->DisplayValue(2);
    const int surface = surfaceShaders->Builds;
    const int volume = volumeShaders->Builds;
    changes += surface + volume > before;
    for (int i = 0; i < 5; ++i)
    {
      this->Scene.Renderer->GetActiveCamera()->Azimuth(2.0);
      this->DisplayValue(1);
    }
    EXPECT_EQ(surfaceShaders->Builds, surface) << (live ? "with" : "without") << " indirect light";
    EXPECT_EQ(volumeShaders->Builds, volume) << (live ? "with" : "without") << " indirect light";
  }
  EXPECT_EQ(changes, 4) << "every switch rebuilds shaders";
}
