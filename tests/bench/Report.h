// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Medians of the timed variants, and ratios of them with limits.
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

/// Cost that a way of drawing adds to a base.
struct Cost
{
  std::string Meaning;
  std::string Subject;
  std::string Base;
};

/// Collects seconds per repetition, and prints a table at the end.
class Report : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  /// Print the tables, and write them as JSON if a file is given. Returns whether all ratios keep their limits.
  bool Conclude(const std::vector<Cost>& costs, const std::vector<Ratio>& ratios,
    const std::string& description, const std::string& jsonFile) const;

private:
  std::map<std::string, std::vector<double>> Seconds;
  std::vector<std::string> Names;
};
}
