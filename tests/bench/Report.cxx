// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace bench
{
namespace
{
double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}
}

bool Report::ReportContext(const Context&)
{
  return true;
}

void Report::ReportRuns(const std::vector<Run>& runs)
{
  for (const Run& run : runs)
  {
    if (run.run_type != Run::RT_Iteration || run.iterations == 0)
    {
      continue;
    }
    const std::string name = run.run_name.function_name;
    if (this->Seconds.find(name) == this->Seconds.end())
    {
      this->Names.push_back(name);
    }
    this->Seconds[name].push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
  }
}

bool Report::Conclude(const std::vector<Cost>& costs, const std::vector<Ratio>& ratios,
  const std::string& description, const std::string& jsonFile) const
{
  nlohmann::json json;
  json["description"] = description;
  std::printf(
    "%s\n\n%-28s %12s %12s %12s\n", description.c_str(), "frame", "median ms", "min ms", "max ms");
  std::map<std::string, double> medians;
  for (const auto& name : this->Names)
  {
    const auto& values = this->Seconds.at(name);
    const auto range = std::minmax_element(values.begin(), values.end());
    medians[name] = Median(values);
    std::printf("%-28s %12.1f %12.1f %12.1f\n", name.c_str(), medians[name] * 1e3,
      *range.first * 1e3, *range.second * 1e3);
    json["milliseconds"][name] = { { "median", medians[name] * 1e3 }, { "min", *range.first * 1e3 },
      { "max", *range.second * 1e3 }, { "runs", values.size() } };
  }
  if (!costs.empty())
  {
    std::printf("\n%-46s %12s %12s\n", "cost", "ms", "of base");
  }
  for (const auto& cost : costs)
  {
    const double base = medians[cost.Base];
    const double added = medians[cost.Subject] - base;
    std::printf("%-46s %12.1f %12.2f\n", cost.Meaning.c_str(), added * 1e3, added / base);
    json["costs"].push_back({ { "meaning", cost.Meaning }, { "milliseconds", added * 1e3 } });
  }
  if (!ratios.empty())
  {
    std::printf("\n%-58s %8s %8s\n", "ratio", "measured", "at most");
  }
  bool good = true;
  for (const auto& ratio : ratios)
  {
    const auto at = [&medians](
                      const std::string& name) { return name.empty() ? 0.0 : medians[name]; };
    const double value =
      (at(ratio.Subject) - at(ratio.SubjectBase)) / (at(ratio.Reference) - at(ratio.ReferenceBase));
    good &= value <= ratio.Limit;
    std::printf("%-58s %8.2f %8.2f%s\n", ratio.Meaning.c_str(), value, ratio.Limit,
      value <= ratio.Limit ? "" : "  exceeded");
    json["ratios"].push_back(
      { { "meaning", ratio.Meaning }, { "measured", value }, { "limit", ratio.Limit } });
  }
  if (!jsonFile.empty())
  {
    std::ofstream file(jsonFile);
    file << json.dump(2) << "\n";
    if (!file)
    {
      std::fprintf(stderr, "penumbra_bench: %s cannot be written.\n", jsonFile.c_str());
      return false;
    }
  }
  return good;
}
}
