// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The path tracer on scenes whose light is known. Prints expected and measured values; exit code 1
 * where a case fails. With --quick, fewer cases and samples, for the tests.
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

bool Asked(const Case& one, const Options& options)
{
  const bool named = (one.Group + ": " + one.Name).find(options.Filter) != std::string::npos;
  return named && (!options.Quick || one.Quick > 0);
}

/// The scene that the case left in the studio, for people.
void KeepPicture(Studio& studio, const Case& one, const std::string& folder)
{
  constexpr int samples = 64;
  constexpr double angle = 40.0;
  studio.Look(one.Eye, one.Target, angle);
  SavePng(studio.Trace(samples), folder + "/" + one.Picture + ".png");
}

bool Run(const Options& options)
{
  const std::vector<Case> all = AllCases();
  double planned = 0.0;
  for (const Case& one : all)
  {
    planned += Asked(one, options) ? (options.Quick ? one.Quick : one.Samples) : 0;
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
  for (const Case& one : all)
  {
    if (!Asked(one, options))
    {
      continue;
    }
    const int samples = options.Quick ? one.Quick : one.Samples;
    studio.OnProgress = [&](double part) {
      progress.Show((done + part * samples) / planned, one.Name);
    };
    results.push_back(Judge(one, samples, one.Measure(studio, samples), options.Quick));
    done += samples;
    progress.Clear();
    Print(results.back(), group);
    group = one.Group;
    failed += results.back().Good ? 0 : 1;
    if (!options.Pictures.empty() && !one.Picture.empty())
    {
      KeepPicture(studio, one, options.Pictures);
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
  CLI::App app(
    "Path traces scenes whose light is known, and compares. Exit code 1 where one fails.");
  app.add_flag("--quick", options.Quick, "fewer cases and samples; chance is allowed for");
  app.add_option("--filter", options.Filter, "only cases with this in their group's or own name");
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
