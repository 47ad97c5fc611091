// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The filter of light that a network guides: what it leaves of the noise, what it keeps, and that it ends, or gives way to the
 * plain filter.
 */
#include "RoomStage.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <unistd.h>

using namespace penumbra_test;

namespace
{
class NeuralDenoising : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ray-traced-light", Width, Height);
    this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
    this->Filter = this->Pass->GetTechnique("denoising");
    this->Panel = this->AddRoomWithPanel();
  }

  /// The picture after some frames. method: "" for no filter.
  Values Draw(const std::string& method, int frames)
  {
    this->Filter->SetEnabled(!method.empty());
    if (!method.empty())
    {
      this->Filter->SetParameterFromText("method", method.c_str());
    }
    this->Pass->Restart();
    return this->After(frames);
  }

  static constexpr int Width = 160;
  static constexpr int Height = 120;
  vtkGITechnique* Filter = nullptr;
  vtkProperty* Panel = nullptr; ///< shines from the ceiling
};
}

TEST_F(NeuralDenoising, LeavesLittleNoise)
{
  const Values truth = this->Draw("", 400);
  for (const int frames : { 1, 8 })
  {
    const Values raw = this->Draw("", frames);
    const Values plain = this->Draw("filter", frames);
    const Values neural = this->Draw("neural", frames);
    const double noise = SquaredError(raw, truth);
    std::printf(
      "%d frames: relMSE %.4f, of it filtered %.4f, by the network %.4f; mean %.4f of %.4f\n",
      frames, noise, SquaredError(plain, truth) / noise, SquaredError(neural, truth) / noise,
      Mean(neural), Mean(truth));
    EXPECT_LT(SquaredError(neural, truth), 0.1 * noise);
    EXPECT_LT(SquaredError(neural, truth), (frames == 1 ? 1.05 : 0.85) * SquaredError(plain, truth));
    EXPECT_NEAR(Mean(neural), Mean(truth), 0.03 * Mean(truth));
  }
}

// Light that is the same everywhere stays: the network only says how much each sample counts.
TEST_F(NeuralDenoising, KeepsUniformLight)
{
  this->ShowBlockInUniformLight();
  ExpectUniformLight(this->Draw("neural", 1));
}

// Half floats hold dim light with fewer digits.
TEST_F(NeuralDenoising, LightMayHaveAnyUnit)
{
  const Values bright = this->Draw("neural", 8);
  this->Panel->SetAmbient(0.01);
  const Values dim = this->Draw("neural", 8);
  double difference = 0.0;
  for (std::size_t i = 0; i < bright.size(); ++i)
  {
    difference += std::abs(100.0 * dim[i] - bright[i]) / static_cast<double>(bright.size());
  }
  std::printf("differences %.5f of %.5f\n", difference, Mean(bright));
  EXPECT_LT(difference, 5e-3 * Mean(bright));
}

TEST_F(NeuralDenoising, EndsInAStillPicture)
{
  const Values early = this->Draw("neural", 20);
  const Values late = this->After(240);
  EXPECT_NE(early, this->Draw("", 20));
  const Values unfiltered = this->After(240);
  EXPECT_EQ(late, unfiltered);
}

// Noise is another elsewhere in the window, so errors are compared.
TEST_F(NeuralDenoising, KnowsItsViewport)
{
  this->Scene.Window->SetSize(Width / 2, Height / 2);
  const Values truth = this->Draw("", 300);
  const double alone = SquaredError(this->Draw("neural", 1), truth);
  this->Scene.Window->SetSize(Width, Height);
  this->Scene.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  const Values window = this->Draw("neural", 1);
  Values placed;
  for (int y = Height / 2; y < Height; ++y)
  {
    const auto row = window.begin() + static_cast<std::ptrdiff_t>(y) * Width;
    placed.insert(placed.end(), row + Width / 2, row + Width);
  }
  std::printf("relMSE %.4f, in a corner of a window %.4f\n", alone, SquaredError(placed, truth));
  EXPECT_LT(SquaredError(placed, truth), 1.3 * alone);
}

TEST_F(NeuralDenoising, DrawsTinyAndEmptyPictures)
{
  for (const auto& size : { std::array<int, 2>{ 1, 1 }, { 3, 2 }, { 17, 1 } })
  {
    this->Scene.Window->SetSize(size[0], size[1]);
    for (const double value : this->Draw("neural", 2))
    {
      EXPECT_TRUE(std::isfinite(value));
    }
  }
  this->Scene.Window->SetSize(Width, Height);
  this->Scene.Renderer->RemoveAllViewProps();
  for (const double value : this->Draw("neural", 2))
  {
    EXPECT_EQ(value, 0.0);
  }
  EXPECT_STREQ(this->Pass->GetLastError(), "");
}

// A driver that does not compile the network.
TEST_F(NeuralDenoising, GivesWayToTheFilter)
{
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("penumbra_network_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "denoising");
  std::ofstream(folder / "denoising" / "layer.glsl") << "this is no shader\n";
  const Values plain = this->Draw("filter", 2);
  this->Pass->SetShaderPath(folder.string().c_str());
  EXPECT_EQ(this->Draw("neural", 2), plain);
  EXPECT_STREQ(this->Pass->GetLastError(), "");
  EXPECT_NE(std::string(this->Pass->GetNotes())
              .find("The denoiser's network does not run here, so light is filtered without it: "),
    std::string::npos)
    << this->Pass->GetNotes();
  this->Pass->SetShaderPath("");
  std::filesystem::remove_all(folder);
}
