// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Path traces scenes with known light, and prints expected and measured values. Exits with 1 if a case fails. With
 * --quick, fewer cases and samples, for the tests.
 */
#include "Report.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <stdexcept>

namespace
{
using namespace validate;

struct Options
{
  bool Quick = false;
  std::string Filter;
  std::string Page;
  std::string Pictures;
};

std::vector<Case> AllCases()
{
  std::vector<Case> all;
  for (const auto& group : { EnergyCases(), ReflectionCases(), OcclusionCases(), LightCases(),
         FormFactorCases(), StrategyCases(), ConvergenceCases() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

bool IsSelected(const Case& candidate, const Options& options)
{
  const std::string name = candidate.Group + ": " + candidate.Name;
  return name.find(options.Filter) != std::string::npos && (!options.Quick || candidate.Quick > 0);
}

/// Save a picture of the scene that the case left in the studio.
void SavePicture(Studio& studio, const Case& each, const std::string& folder)
{
  constexpr int samples = 64;
  constexpr double angle = 40.0;
  studio.Look(each.Eye, each.Target, angle);
  SavePng(studio.Trace(samples), folder + "/" + each.Picture + ".png");
}

bool Run(const Options& options)
{
  const std::vector<Case> all = AllCases();
  double planned = 0.0;
  for (const Case& each : all)
  {
    planned += IsSelected(each, options) ? (options.Quick ? each.Quick : each.Samples) : 0;
  }
  if (planned == 0.0)
  {
    throw std::runtime_error("no case's name contains '" + options.Filter + "'.");
  }
  if (!options.Pictures.empty())
  {
    std::filesystem::create_directories(options.Pictures);
  }
  Studio studio;
  Progress progress;
  std::vector<Result> results;
  double done = 0.0;
  std::string group;
  int failed = 0;
  for (const Case& each : all)
  {
    if (!IsSelected(each, options))
    {
      continue;
    }
    const int samples = options.Quick ? each.Quick : each.Samples;
    studio.OnProgress = [&](double part) {
      progress.Show((done + part * samples) / planned, each.Name);
    };
    results.push_back(Judge(each, samples, each.Measure(studio, samples), options.Quick));
    done += samples;
    progress.Clear();
    Print(results.back(), group);
    group = each.Group;
    failed += results.back().Passed ? 0 : 1;
    if (!options.Pictures.empty() && !each.Picture.empty())
    {
      SavePicture(studio, each, options.Pictures);
    }
  }
  std::printf(
    "\n%zu cases, %d failed; drawn by %s\n", results.size(), failed, studio.Description().c_str());
  if (!options.Page.empty())
  {
    WritePage(options.Page, results, studio.Description());
  }
  return failed == 0;
}
}

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Path traces scenes with known light, and compares measured with expected values. "
               "Exits with 1 if a case fails.");
  app.add_flag("--quick", options.Quick, "fewer cases and samples, with wider limits for noise");
  app.add_option("--filter", options.Filter, "only cases whose group or name contains this text");
  app.add_option("--page", options.Page, "also write the table to this file, as Markdown");
  app.add_option(
    "--pictures", options.Pictures, "also write pictures of the scenes to this folder");
  CLI11_PARSE(app, argc, argv);
  try
  {
    return Run(options) ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "penumbra_validate: %s\n", error.what());
    return 2;
  }
}
