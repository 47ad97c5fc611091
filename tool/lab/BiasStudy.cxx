// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/BiasStudy.h"

#include "image/Capture.h"
#include "lab/ShadowBench.h"

#include <vtkGITechnique.h>

#include <algorithm>
#include <optional>

namespace penumbra::tool
{
namespace
{
constexpr double PixelsPerTexel = 2;
constexpr int SmallestMap = 64;

// What a crop shows of the picture: wide enough for some twenty to forty texels.
constexpr int CropSide = 72;

// Tracing the truth takes about as long as so many masks: its part of the progress.
constexpr int TruthSteps = 10;

using Biases = std::vector<std::pair<std::string, double>>;

Biases GetBiases(vtkGITechnique* maps)
{
  Biases biases;
  for (const std::string& kind : BiasKinds(maps))
  {
    biases.emplace_back(kind, maps->GetParameter((kind + "-bias").c_str()));
  }
  return biases;
}

void SetBiases(vtkGITechnique* maps, const Biases& biases)
{
  for (const auto& [kind, bias] : biases)
  {
    maps->SetParameter((kind + "-bias").c_str(), bias);
  }
}

/// That kind's, and no other.
void SetBias(vtkGITechnique* maps, const std::string& kind, double bias)
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
    const BiasStudyOptions& options = this->Study.Options;
    this->Steps = TruthSteps + options.Kinds.size() * (2 + options.Biases.size());
    this->JudgeView();
    this->Advance(TruthSteps);
    this->Study.AtDefaults = this->Judge->Measure(this->Bench.DrawMask());
    this->Study.OverviewAtDefaults = this->Shown();
    this->FindPlaces();
    for (const std::string& kind : this->Study.Options.Kinds)
    {
      this->Sweep(kind);
    }
    this->Bench.ShowTruth();
    this->Study.Overview = this->Shown();
    return std::move(this->Study);
  }

private:
  void Advance(int steps = 1)
  {
    this->Done += steps;
    this->Progress.Advance(double(this->Done) / this->Steps);
  }
  Picture Shown() { return CaptureWindow(this->Bench.Window(), false); }

  void JudgeView()
  {
    vtkGITechnique* maps = this->Bench.Maps();
    if (this->Study.Options.Resolution > 0)
    {
      maps->SetParameter("resolution", this->Study.Options.Resolution);
    }
    else
    {
      FitResolution(this->Bench);
    }
    const BiasJudge& judge = this->Judge.emplace(JudgeShadows(this->Bench));
    this->Study.Resolution = static_cast<int>(maps->GetParameter("resolution"));
    this->Study.FilterRadius = maps->GetParameter("filter-radius");
    this->Study.Defaults = GetBiases(maps);
    this->Study.TexelWidth = this->Bench.TexelInTheMiddle();
    this->Study.PixelWidth = MedianPixelWidth(judge.View());
    this->Study.Lost = judge.Lost();
    this->Study.LitPixels = judge.LitPixels();
    this->Study.DarkPixels = judge.DarkPixels();
    this->Study.ContactPoints = judge.ContactPoints();
    this->Study.OutlinePoints = judge.OutlinePoints();
  }

  /// Acne at the smallest bias, in one place so that kinds can be compared; gaps at the greatest, which
  /// each kind has elsewhere.
  void FindPlaces()
  {
    const LitView& view = this->Judge->View();
    std::vector<double> acne(view.PixelCount()), gap(view.PixelCount());
    for (const std::string& kind : this->Study.Options.Kinds)
    {
      SetBias(this->Bench.Maps(), kind, this->Study.Options.Biases.front());
      const std::vector<float> least = this->Bench.DrawMask();
      this->Advance();
      SetBias(this->Bench.Maps(), kind, this->Study.Options.Biases.back());
      const std::vector<float> most = this->Bench.DrawMask();
      this->Advance();
      for (std::size_t i = 0; i < acne.size(); ++i)
      {
        acne[i] += view.Light[i] * std::max(this->Judge->Error(least, i), 0.0);
        const float leak = view.Receiver[i] ? most[i] - view.Truth[i] : 0.0f;
        gap[i] = view.Light[i] * std::max(leak, 0.0f);
      }
      this->Study.GapPlaces.push_back(HeaviestSquare(gap, view.Width, view.Height));
    }
    this->Study.AcnePlace = HeaviestSquare(acne, view.Width, view.Height);
  }

  void Sweep(const std::string& kind)
  {
    BiasSweep sweep{ kind, kind + "-bias", {} };
    std::vector<BiasStudy::Views> strip;
    const Crop place = this->Study.GapPlaces[this->Study.Sweeps.size()];
    for (const double bias : this->Study.Options.Biases)
    {
      SetBias(this->Bench.Maps(), kind, bias);
      sweep.Samples.push_back({ bias, this->Judge->Measure(this->Bench.DrawMask()) });
      const Picture shown = this->Shown();
      strip.push_back({ Cut(shown, this->Study.AcnePlace), Cut(shown, place) });
      this->Advance();
    }
    this->Study.Sweeps.push_back(std::move(sweep));
    this->Study.Strips.push_back(std::move(strip));
  }

  ShadowBench& Bench;
  Step Progress;
  BiasStudy Study;
  std::optional<BiasJudge> Judge;
  std::size_t Steps = 1;
  std::size_t Done = 0;
};
}

Picture Cut(const Picture& picture, const Crop& crop)
{
  Picture part(crop.Width, crop.Height, picture.Channels);
  for (int y = 0; y < crop.Height; ++y)
  {
    const float* row = picture.Pixel(std::size_t(crop.Y + y) * picture.Width + crop.X);
    std::copy_n(
      row, std::size_t(crop.Width) * picture.Channels, part.Pixel(std::size_t(y) * crop.Width));
  }
  return part;
}

BiasJudge JudgeShadows(ShadowBench& bench)
{
  vtkGITechnique* maps = bench.Maps();
  LitView truth = bench.TraceTruth();
  const Biases biases = GetBiases(maps);
  SetBias(maps, "", 0);
  const std::vector<float> unbiased = bench.DrawMask();
  SetBiases(maps, biases);
  // The filter spreads every edge by its radius, on purpose.
  const double band = BiasJudge::EdgeBand + maps->GetParameter("filter-radius");
  return { std::move(truth), unbiased, band };
}

void FitResolution(ShadowBench& bench)
{
  const auto resolution = static_cast<int>(bench.Maps()->GetParameter("resolution"));
  const double pixel = MedianPixelWidth(bench.TraceTruth());
  bench.Maps()->SetParameter("resolution", ChooseResolution(pixel, resolution));
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
