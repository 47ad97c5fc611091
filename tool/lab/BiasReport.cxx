// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/BiasReport.h"

#include <fmt/format.h>

namespace penumbra::tool
{
namespace
{
nlohmann::ordered_json Describe(const EdgeGap& gap)
{
  return { { "texels", gap.Texels }, { "world", gap.World } };
}

nlohmann::ordered_json Describe(const BiasErrors& errors)
{
  return { { "acne", errors.Acne }, { "leak", errors.Leak }, { "gap", errors.Gap() },
    { "contact-gap", Describe(errors.Contact) }, { "outline-gap", Describe(errors.Outline) } };
}

nlohmann::ordered_json Describe(const BiasSweep& sweep, const BiasLimits& limits)
{
  nlohmann::ordered_json described = { { "kind", sweep.Kind }, { "parameter", sweep.Parameter },
    { "window", nullptr } };
  if (const auto window = sweep.Window(limits))
  {
    described["window"] = { { "low", window->Low }, { "high", window->High },
      { "reaches-end", window->ReachesEnd }, { "choice", window->Choice } };
  }
  described["best"] = sweep.Best(limits).Bias;
  for (const BiasSample& sample : sweep.Samples)
  {
    nlohmann::ordered_json row = { { "bias", sample.Bias } };
    row.update(Describe(sample.Errors));
    described["samples"].push_back(row);
  }
  return described;
}

std::string Summarize(const BiasErrors& errors)
{
  return fmt::format(
    "acne {}, gap {:.2f} texels (in world units {:.2g} at contact, {:.2g} at outlines)",
    FormatPercent(errors.Acne), errors.Gap(), errors.Contact.World, errors.Outline.World);
}
}

nlohmann::ordered_json DescribeStudy(const BiasStudy& study)
{
  nlohmann::ordered_json defaults;
  for (const auto& [kind, value] : study.Defaults)
  {
    defaults[kind + "-bias"] = value;
  }
  nlohmann::ordered_json described = { { "resolution", study.Resolution },
    { "filter-radius", study.FilterRadius }, { "texel-world", study.TexelWidth },
    { "pixel-texels", study.PixelWidth },
    { "limits", { { "acne", study.Options.Limits.Acne }, { "gap", study.Options.Limits.Gap } } },
    { "lost", study.Lost },
    { "pixels", { { "lit", study.LitPixels }, { "dark", study.DarkPixels } } },
    { "edge-points", { { "contact", study.ContactPoints }, { "outline", study.OutlinePoints } } },
    { "defaults", defaults } };
  described["defaults"].update(Describe(study.AtDefaults));
  for (const BiasSweep& sweep : study.Sweeps)
  {
    described["sweeps"].push_back(Describe(sweep, study.Options.Limits));
  }
  return described;
}

std::string FormatPercent(double share)
{
  constexpr double least = 0.001;
  const double percent = 100 * share;
  return percent > 0 && percent < least ? fmt::format("under {:g} %", least)
    : percent < 10                      ? fmt::format("{:.2g} %", percent)
                                        : fmt::format("{:.0f} %", percent);
}

std::string SummarizeWindow(const BiasSweep& sweep, const BiasLimits& limits)
{
  const BiasSample& best = sweep.Best(limits);
  const auto window = sweep.Window(limits);
  if (!window)
  {
    return fmt::format("none safe from {:g} to {:g} texels; nearest {:g}",
      sweep.Samples.front().Bias, sweep.Samples.back().Bias, best.Bias);
  }
  if (window->High == window->Low && !window->ReachesEnd)
  {
    return fmt::format("safe at {:g} texels only; take that", window->Choice);
  }
  return fmt::format("safe from {:g} to {:g} texels{}; take {:g}", window->Low, window->High,
    window->ReachesEnd ? " at least" : "", window->Choice);
}

std::string SummarizeDefaults(const BiasStudy& study)
{
  std::string together;
  for (const auto& [kind, value] : study.Defaults)
  {
    together += fmt::format("{}{} {:g}", together.empty() ? "" : ", ", kind, value);
  }
  const bool safe = ShareOfLimits(study.AtDefaults, study.Options.Limits) <= 1;
  return fmt::format("as set ({}): {}", together, safe ? "safe" : "not safe here");
}

std::string SummarizeStudy(const BiasStudy& study)
{
  const BiasLimits& limits = study.Options.Limits;
  std::string text;
  for (const BiasSweep& sweep : study.Sweeps)
  {
    text += fmt::format("{} bias: {}: {}\n", sweep.Kind, SummarizeWindow(sweep, limits),
      Summarize(sweep.Best(limits).Errors));
  }
  return text + fmt::format("{}: {}\n", SummarizeDefaults(study), Summarize(study.AtDefaults));
}
}
