// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A row of balls of physically based materials, lit by an environment alone.
 */
#pragma once

#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include <vtkImageData.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>

#include <cmath>
#include <string>
#include <vector>

namespace penumbra_test
{
/// An image of one value. Integer types store 1 as their largest value.
template <typename Value>
vtkSmartPointer<vtkTexture> ConstantTexture(double value, bool srgb = false)
{
  const double one =
    std::is_integral<Value>::value ? static_cast<double>(std::numeric_limits<Value>::max()) : 1.0;
  vtkNew<vtkImageData> image;
  image->SetDimensions(32, 16, 1);
  image->AllocateScalars(vtkTypeTraits<Value>::VTK_TYPE_ID, 3);
  auto* values = static_cast<Value*>(image->GetScalarPointer());
  const double stored = std::is_integral<Value>::value ? std::round(value * one) : value;
  std::fill_n(values, 3 * image->GetNumberOfPoints(), static_cast<Value>(stored));
  auto texture = EnvironmentTexture(image);
  texture->SetUseSRGBColorSpace(srgb);
  return texture;
}

class EnvironmentStage
{
public:
  struct Ball
  {
    double Metallic;
    double Roughness;
  };
  /// Display values in the middle of a ball.
  struct Grey
  {
    double Mean = 0.0;
    double Deviation = 0.0;
  };

  EnvironmentStage()
  {
    auto* renderer = this->Renderer();
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->UseImageBasedLightingOn();
    // VTK's default tables are large and slow to compute on a CPU.
    renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(16);
    renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
    renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.1f);
    renderer->GetEnvMapLookupTable()->SetLUTSize(64);
    renderer->GetEnvMapLookupTable()->SetLUTSamples(256);
    AddFaintLight(renderer);
  }

  vtkOpenGLRenderer* Renderer()
  {
    return static_cast<vtkOpenGLRenderer*>(this->Scene.Renderer.Get());
  }

  void SetEnvironment(vtkTexture* texture, bool srgb = false)
  {
    this->Renderer()->SetEnvironmentTexture(texture, srgb);
  }

  /// Add balls side by side, each in its own square of the picture.
  std::vector<Ball> AddBalls(const std::vector<Ball>& balls, double opacity = 1.0)
  {
    this->Count = static_cast<int>(balls.size());
    this->Scene.Window->SetSize(this->Count * Side, Side);
    double x = 0.0;
    for (const Ball& ball : balls)
    {
      vtkNew<vtkSphereSource> source;
      source->SetThetaResolution(48);
      source->SetPhiResolution(48);
      source->SetRadius(0.45);
      source->SetCenter(x, 0.0, 0.0);
      x += 1.0;
      vtkProperty* property = this->Scene.Add(source)->GetProperty();
      property->SetInterpolationToPBR();
      property->SetColor(0.8, 0.8, 0.8);
      property->SetMetallic(ball.Metallic);
      property->SetRoughness(ball.Roughness);
      property->SetOpacity(opacity);
      property->SetBackfaceCulling(opacity < 1.0);
    }
    // The camera is so far away that it sees the front of every ball.
    vtkCamera* camera = this->Renderer()->GetActiveCamera();
    const double middle = 0.5 * (this->Count - 1);
    camera->SetFocalPoint(middle, 0.0, 0.0);
    camera->SetPosition(middle, 0.0, 60.0);
    camera->SetViewAngle(2.0 * std::atan(0.5 / 60.0) * 180.0 / vtkMath::Pi());
    this->Renderer()->ResetCameraClippingRange();
    return balls;
  }

  /// Draw with a preset, or with VTK alone ("stock"), and measure every ball.
  std::vector<Grey> Measure(const std::string& preset, int frames)
  {
    this->Renderer()->SetPass(nullptr);
    if (preset != "stock")
    {
      this->Pass = this->Scene.SetPasses().front();
      EXPECT_TRUE(this->Pass->SetPreset(preset.c_str()));
      this->Pass->KeepRadianceOn();
    }
    for (int i = 1; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    const Picture picture = this->Last = Shoot(this->Scene.Window);
    Save(picture,
      std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "-" + preset);
    EXPECT_TRUE(TakeMessages().empty());
    std::vector<Grey> balls;
    for (int ball = 0; ball < this->Count; ++ball)
    {
      double sum = 0.0;
      double squares = 0.0;
      for (int i = 0; i < Middle * Middle; ++i)
      {
        const double value = picture.Grey(
          ball * Side + (Side - Middle) / 2 + i % Middle, (Side - Middle) / 2 + i / Middle);
        sum += value;
        squares += value * value;
      }
      const double mean = sum / (Middle * Middle);
      balls.push_back(
        { mean, std::sqrt(std::max(0.0, squares / (Middle * Middle) - mean * mean)) });
    }
    return balls;
  }

  static constexpr int Side = 40;   // width of a ball's square in pixels
  static constexpr int Middle = 12; // width of its measured middle
  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  Picture Last; ///< the last measured picture

private:
  int Count = 0;
};
}
