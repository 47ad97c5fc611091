// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Case.h"

#include <cstdio>

namespace validate
{
struct Result
{
  const Case* Source;
  int Samples;
  Outcome Measurement;
  double Expected;
  bool Passed;
  std::string Verdict;
};

/// Compare the measurement of a case with its rule. quick: three standard errors are allowed if they are more than the
/// tolerance.
Result Judge(const Case& source, int samples, const Outcome& measurement, bool quick);

/// Print one line, with a heading if the group is not that of the previous line.
void Print(const Result& result, const std::string& previousGroup);

/// Write the page of documentation.
void WritePage(
  const std::string& file, const std::vector<Result>& results, const std::string& renderer);

/// A progress bar with the remaining time. Shown on terminals only.
class Progress
{
public:
  Progress();
  void Show(double fraction, const std::string& what);
  void Clear();

private:
  double Started;
  double LastShown = 0.0;
  bool Terminal;
};
}
