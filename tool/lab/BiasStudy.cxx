// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BiasStudy.h"

#include "../scene/Capture.h"
#include "ShadowBench.h"

#include <vtkGITechnique.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
constexpr double PixelsPerTexel = 2;
constexpr int SmallestMap = 64;

// What a crop shows of the picture: wide enough for some twenty to forty texels.
constexpr int CropSide = 72;

void SetBiases(vtkGITechnique* maps, const std::string& kind, double bias)
{
  for (const std::string& each : BiasKinds(maps))
  {
    maps->SetParameter((each + "-bias").c_str(), each == kind ? bias : 0);
  }
}

/// The square of the picture in which the sum of the weights is greatest; a tie goes to the first.
Crop HeaviestSquare(const std::vector<double>& weights, int width, int height)
{
  const int side = std::min({ CropSide, width, height });
  // Sums over everything above and to the left of a pixel.
  std::vector<double> sums(std::size_t(width + 1) * (height + 1));
  const auto sum = [&](int x, int y) -> double& { return sums[std::size_t(y) * (width + 1) + x]; };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      sum(x + 1, y + 1) =
        weights[std::size_t(y) * width + x] + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
    }
  }
  Crop best{ (width - side) / 2, (height - side) / 2, side, side };
  double most = 0;
  for (int y = 0; y + side <= height; ++y)
  {
    for (int x = 0; x + side <= width; ++x)
    {
      const double inside =
        sum(x + side, y + side) - sum(x, y + side) - sum(x + side, y) + sum(x, y);
      if (inside > most + 1e-6)
      {
        most = inside;
        best.X = x;
        best.Y = y;
      }
    }
  }
  return best;
}

Picture Cut(const Picture& picture, const Crop& crop)
{
  Picture part(crop.Width, crop.Height, picture.Channels);
  for (int y = 0; y < crop.Height; ++y)
  {
    const float* row = picture.Pixel(std::size_t(crop.Y + y) * picture.Width + crop.X);
    std::copy_n(row, std::size_t(crop.Width) * picture.Channels, part.Pixel(std::size_t(y) * crop.Width));
  }
  return part;
}

class Experiment
{
public:
  Experiment(ShadowBench& bench, const BiasStudyOptions& options, Reporter& reporter)
    : Bench(bench)
    , Progress(reporter, "sweeping the bias")
  {
    this->Study.Options = options;
  }

  BiasStudy Run()
  {
    this->NoteDefaults();
    this->Steps = 10.0 + this->Study.Options.Kinds.size() * (2.0 + this->Study.Options.Biases.size());
    this->Judge = this->JudgeView();
    this->Study.AtDefaults = this->Judge->Measure(this->Bench.DrawMask());
    this->FindPlaces();
    for (const std::string& kind : this->Study.Options.Kinds)
    {
      this->Sweep(kind);
    }
    this->Bench.ShowTruth();
    this->Study.Overview = this->Shown();
    this->Study.TrueAcnePlace = Cut(this->Study.Overview, this->Study.AcnePlace);
    this->Study.TrueGapPlace = Cut(this->Study.Overview, this->Study.GapPlace);
    return std::move(this->Study);
  }

private:
  void Advance() { this->Progress.Advance(++this->Done / this->Steps); }
  Picture Shown() { return CaptureWindow(this->Bench.Window(), false); }

  void NoteDefaults()
  {
    for (const std::string& kind : BiasKinds(this->Bench.Maps()))
    {
      this->Study.Defaults.emplace_back(
        kind, this->Bench.Maps()->GetParameter((kind + "-bias").c_str()));
    }
    this->Study.FilterRadius = this->Bench.Maps()->GetParameter("filter-radius");
  }

  std::unique_ptr<BiasJudge> JudgeView()
  {
    // The filter spreads every edge by its radius, on purpose.
    const double band = BiasJudge::EdgeBand + this->Study.FilterRadius;
    vtkGITechnique* maps = this->Bench.Maps();
    int& resolution = this->Study.Resolution = this->Study.Options.Resolution;
    if (resolution == 0)
    {
      const auto preset = static_cast<int>(maps->GetParameter("resolution"));
      const LitView view = this->Bench.TraceTruth();
      resolution = ChooseResolution(MedianPixelWidth(view), preset);
    }
    maps->SetParameter("resolution", resolution);
    LitView view = this->Bench.TraceTruth();
    SetBiases(maps, "", 0);
    auto judge = std::make_unique<BiasJudge>(std::move(view), this->Bench.DrawMask(), band);
    for (const auto& [kind, bias] : this->Study.Defaults)
    {
      maps->SetParameter((kind + "-bias").c_str(), bias);
    }
    this->Study.TexelWidth = this->Bench.TexelInTheMiddle();
    this->Study.PixelWidth = MedianPixelWidth(judge->View());
    this->Study.Lost = judge->Lost();
    this->Study.LitPixels = judge->LitPixels();
    this->Study.DarkPixels = judge->DarkPixels();
    this->Study.ContactPoints = judge->ContactPoints();
    this->Study.OutlinePoints = judge->OutlinePoints();
    return judge;
  }

  /// Of all kinds together, so that they can be compared: acne at the smallest bias, gaps at the
  /// greatest.
  void FindPlaces()
  {
    const LitView& view = this->Judge->View();
    std::vector<double> acne(view.PixelCount()), gap(view.PixelCount());
    for (const std::string& kind : this->Study.Options.Kinds)
    {
      SetBiases(this->Bench.Maps(), kind, this->Study.Options.Biases.front());
      const std::vector<float> least = this->Bench.DrawMask();
      this->Advance();
      SetBiases(this->Bench.Maps(), kind, this->Study.Options.Biases.back());
      const std::vector<float> most = this->Bench.DrawMask();
      this->Advance();
      for (std::size_t i = 0; i < acne.size(); ++i)
      {
        acne[i] += std::max(this->Judge->Error(least, i), 0.0);
        gap[i] += view.Receiver[i] ? std::max(most[i] - view.Truth[i], 0.0f) : 0.0f;
      }
    }
    this->Study.AcnePlace = HeaviestSquare(acne, view.Width, view.Height);
    this->Study.GapPlace = HeaviestSquare(gap, view.Width, view.Height);
  }

  void Sweep(const std::string& kind)
  {
    BiasSweep sweep{ kind, kind + "-bias", {} };
    std::vector<BiasStudy::Views> strip;
    for (const double bias : this->Study.Options.Biases)
    {
      SetBiases(this->Bench.Maps(), kind, bias);
      sweep.Samples.push_back({ bias, this->Judge->Measure(this->Bench.DrawMask()) });
      const Picture shown = this->Shown();
      strip.push_back({ Cut(shown, this->Study.AcnePlace), Cut(shown, this->Study.GapPlace) });
      this->Advance();
    }
    this->Study.Sweeps.push_back(std::move(sweep));
    this->Study.Strips.push_back(std::move(strip));
  }

  ShadowBench& Bench;
  Step Progress;
  BiasStudy Study;
  std::unique_ptr<BiasJudge> Judge;
  double Steps = 1;
  double Done = 0;
};
}

int ChooseResolution(double pixelWidth, int resolution)
{
  while (resolution > SmallestMap && pixelWidth * PixelsPerTexel > 1)
  {
    resolution /= 2;
    pixelWidth /= 2;
  }
  return resolution;
}

BiasStudy StudyBias(ShadowBench& bench, const BiasStudyOptions& options, Reporter& reporter)
{
  return Experiment(bench, options, reporter).Run();
}
}
