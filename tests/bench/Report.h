// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Medians of the timed variants, and the ratios that the project promises.
 */
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace bench
{
/// (subject - base) / (reference - reference base); an empty base counts as zero.
struct Ratio
{
  std::string Meaning;
  std::string Subject, SubjectBase;
  std::string Reference, ReferenceBase;
  double Limit;
};

/// What a way of drawing adds to a base.
struct Cost
{
  std::string Meaning;
  std::string Subject;
  std::string Base;
};

/// Collects seconds per repetition; prints a table at the end.
class Report : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  /// Print the tables, and write them as JSON where a file is named. True if every ratio holds.
  bool Conclude(const std::vector<Cost>& costs, const std::vector<Ratio>& ratios,
    const std::string& description, const std::string& jsonFile) const;

private:
  std::map<std::string, std::vector<double>> Seconds;
  std::vector<std::string> Names;
};
}
