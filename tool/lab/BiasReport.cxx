// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BiasReport.h"

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
  return fmt::format("acne {:.3g} %, gap {:.2f} texels ({:.3g} at contact, in world units)",
    100 * errors.Acne, errors.Gap(), errors.Contact.World);
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
    { "lost", study.Lost }, { "pixels", { { "lit", study.LitPixels }, { "dark", study.DarkPixels } } },
    { "edge-points", { { "contact", study.ContactPoints }, { "outline", study.OutlinePoints } } },
    { "defaults", defaults } };
  described["defaults"].update(Describe(study.AtDefaults));
  for (const BiasSweep& sweep : study.Sweeps)
  {
    described["sweeps"].push_back(Describe(sweep, study.Options.Limits));
  }
  return described;
}

std::string SummarizeWindow(const BiasSweep& sweep, const BiasLimits& limits)
{
  const BiasSample& best = sweep.Best(limits);
  const auto window = sweep.Window(limits);
  if (!window)
  {
    return fmt::format("none safe from {:g} to {:g} texels; nearest {:g}", sweep.Samples.front().Bias,
      sweep.Samples.back().Bias, best.Bias);
  }
  return fmt::format("safe from {:g} to {:g} texels{}; take {:g}", window->Low, window->High,
    window->ReachesEnd ? " at least" : "", window->Choice);
}

std::string SummarizeStudy(const BiasStudy& study)
{
  std::string text;
  for (const BiasSweep& sweep : study.Sweeps)
  {
    text += fmt::format("{} bias: {}: {}\n", sweep.Kind,
      SummarizeWindow(sweep, study.Options.Limits),
      Summarize(sweep.Best(study.Options.Limits).Errors));
  }
  std::string together;
  for (const auto& [kind, value] : study.Defaults)
  {
    together += fmt::format("{}{} {:g}", together.empty() ? "" : ", ", kind, value);
  }
  const bool safe = ShareOfLimits(study.AtDefaults, study.Options.Limits) <= 1;
  return text +
    fmt::format("as set ({}): {}: {}\n", together, safe ? "safe" : "not safe here",
      Summarize(study.AtDefaults));
}
}
