// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra compare: the difference of a picture from a reference.
#include "commands/Commands.h"

#include "common/Failure.h"
#include "image/Metrics.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace penumbra::tool
{
namespace
{
class CompareCommand
{
public:
  CLI::App* Declare(CLI::App& app)
  {
    CLI::App* command =
      app.add_subcommand("compare", "measure the difference of a picture from a reference");
    command->add_option("PICTURE", this->Picture, "picture to compare")->required();
    command->add_option("REFERENCE", this->Reference, "picture to compare with")->required();
    command
      ->add_option("--epsilon", this->Options.Epsilon, "of relMSE: (a - b)^2 / (b^2 + epsilon)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
    command
      ->add_option(
        "--tolerance", this->Options.Tolerance, "in 255ths: count pixels with a greater difference")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
    command->add_option("--mask-above", this->Options.MaskAbove,
      "leave out pixels with a channel above this value in either picture, and their neighbours: "
      "visible lights (SSIM, and FLIP near them, still see them)");
    command
      ->add_option("--pixels-per-degree", this->Options.PixelsPerDegree,
        "of FLIP: pixels in a degree of the viewer's sight")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
    command->add_option("--flip", this->FlipFile, "write a picture of FLIP");
    command->add_option("--diff", this->Difference, "write a picture of the absolute difference");
    command->add_option("--diff-gain", this->Gain, "factor of the difference")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
    command->add_option("--max-relmse", this->MaximumRelativeMse, "fail above this value");
    command->add_option("--min-ssim", this->MinimumSsim, "fail below this value");
    command->add_option(
      "--max-flip", this->MaximumFlip, "fail if the mean of FLIP is above this value");
    command->add_option("--fail-over", this->MaximumFraction,
      "fail if a greater fraction of pixels exceeds the tolerance");
    command->add_flag("--json", this->Json, "print JSON");
    command->footer(
      "Exit status: 0 within the limits, 1 outside them or on failure, 2 on wrong usage.\n"
      "Examples:\n"
      "  penumbra compare a.png b.png\n"
      "  penumbra compare a.exr b.exr --max-relmse 0.01 --diff difference.png\n"
      "  penumbra compare a.png b.png --tolerance 2 --fail-over 0.001 --json");
    return command;
  }

  int Run(Console& console)
  {
    for (const std::string& file : { this->Difference, this->FlipFile })
    {
      if (!file.empty())
      {
        RequireWritablePicture(file);
      }
    }
    tool::Picture a, b;
    {
      Step step(console, fmt::format("reading '{}' and '{}'", this->Picture, this->Reference));
      a = ReadPicture(this->Picture);
      b = ReadPicture(this->Reference);
    }
    if (a.Width != b.Width || a.Height != b.Height)
    {
      Fail(
        "'{}' has {}x{} pixels and '{}' has {}x{}: only pictures of the same size can be compared",
        this->Picture, a.Width, a.Height, this->Reference, b.Width, b.Height);
    }
    const Metrics metrics = Measure(a, b, this->Options);
    if (!this->Difference.empty())
    {
      WritePicture(this->Difference, DifferencePicture(a, b, this->Gain));
    }
    if (!this->FlipFile.empty())
    {
      WritePicture(this->FlipFile, GreyPicture(metrics.Flip, a.Width));
    }
    this->Print(metrics);
    return this->Judge(metrics, console);
  }

private:
  void Print(const Metrics& metrics) const
  {
    nlohmann::ordered_json values = { { "relmse", metrics.RelativeMse },
      { "signed-mean", metrics.SignedMean }, { "p99", metrics.Percentile99 },
      { "maximum", metrics.Maximum }, { "ssim", metrics.Ssim },
      { "delta-e-mean", metrics.DeltaEMean }, { "delta-e-p99", metrics.DeltaE99 },
      { "delta-h-mean", metrics.DeltaHMean }, { "delta-h-p99", metrics.DeltaH99 },
      { "flip-mean", metrics.FlipMean }, { "flip-p95", metrics.Flip95 },
      { "fraction-over", metrics.FractionOver }, { "tolerance", this->Options.Tolerance },
      { "epsilon", this->Options.Epsilon }, { "non-finite-pixels", metrics.NonFinite } };
    const bool masks = std::isfinite(this->Options.MaskAbove);
    if (masks)
    {
      values["masked-pixels"] = metrics.Masked;
    }
    if (this->Json)
    {
      tool::Print(values.dump(2) + "\n");
      return;
    }
    fmt::print("relMSE            {:.6g}   (epsilon {:g})\n"
               "signed mean       {:+.6g}   (luminance, picture - reference)\n"
               "99th percentile   {:.6g}\n"
               "maximum           {:.6g}\n"
               "SSIM              {:.6f}\n"
               "ΔE (CIEDE2000)    {:.4g} mean, {:.4g} 99th percentile\n"
               "ΔH (its hue part) {:.4g} mean, {:.4g} 99th percentile\n"
               "FLIP              {:.4g} mean, {:.4g} 95th percentile   ({:g} pixels per degree)\n"
               "over {:g}/255        {:.6g} of the pixels\n"
               "not finite        {} pixels\n",
      metrics.RelativeMse, this->Options.Epsilon, metrics.SignedMean, metrics.Percentile99,
      metrics.Maximum, metrics.Ssim, metrics.DeltaEMean, metrics.DeltaE99, metrics.DeltaHMean,
      metrics.DeltaH99, metrics.FlipMean, metrics.Flip95, this->Options.PixelsPerDegree,
      this->Options.Tolerance, metrics.FractionOver, metrics.NonFinite);
    if (masks)
    {
      fmt::print("masked            {} pixels\n", metrics.Masked);
    }
  }

  int Judge(const Metrics& metrics, Console& console) const
  {
    std::vector<std::string> reasons;
    if (this->MaximumRelativeMse && metrics.RelativeMse > *this->MaximumRelativeMse)
    {
      reasons.push_back(
        fmt::format("relMSE {:.6g} is above {:g}", metrics.RelativeMse, *this->MaximumRelativeMse));
    }
    if (this->MinimumSsim && metrics.Ssim < *this->MinimumSsim)
    {
      reasons.push_back(fmt::format("SSIM {:.6f} is below {:g}", metrics.Ssim, *this->MinimumSsim));
    }
    if (this->MaximumFraction && metrics.FractionOver > *this->MaximumFraction)
    {
      reasons.push_back(fmt::format("{:.6g} of the pixels are over {:g}/255, more than {:g}",
        metrics.FractionOver, this->Options.Tolerance, *this->MaximumFraction));
    }
    if (this->MaximumFlip && metrics.FlipMean > *this->MaximumFlip)
    {
      reasons.push_back(fmt::format(
        "the mean of FLIP, {:.6g}, is above {:g}", metrics.FlipMean, *this->MaximumFlip));
    }
    const bool limited =
      this->MaximumRelativeMse || this->MinimumSsim || this->MaximumFlip || this->MaximumFraction;
    if (limited && metrics.NonFinite > 0)
    {
      reasons.push_back(fmt::format("{} pixels are not finite", metrics.NonFinite));
    }
    if (reasons.empty())
    {
      return 0;
    }
    console.Error(fmt::format(
      "'{}' is too far from '{}': {}", this->Picture, this->Reference, fmt::join(reasons, ", ")));
    return Failure::Failed;
  }

  std::string Picture;
  std::string Reference;
  MetricOptions Options;
  std::string Difference;
  std::string FlipFile;
  double Gain = 8;
  std::optional<double> MaximumRelativeMse;
  std::optional<double> MinimumSsim;
  std::optional<double> MaximumFlip;
  std::optional<double> MaximumFraction;
  bool Json = false;
};
}

void AddCompareCommand(CLI::App& app, Console& console, int& status)
{
  AddCommand<CompareCommand>(app, console, status);
}
}
