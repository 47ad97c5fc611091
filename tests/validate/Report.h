// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Case.h"

#include <cstdio>

namespace validate
{
struct Result
{
  const Case* Of;
  int Samples;
  Outcome Found;
  double Expected;
  bool Good;
  std::string Verdict;
};

/// quick: fewer samples, so that three standard errors are allowed where they are more than the
/// tolerance.
Result Judge(const Case& asked, int samples, const Outcome& found, bool quick);

/// One line, below the group's heading where that is new.
void Print(const Result& result, const std::string& groupBefore);

/// A page of documentation.
void WritePage(
  const std::string& file, const std::vector<Result>& results, const std::string& renderer);

/// A bar on a terminal with the time left; silent elsewhere.
class Progress
{
public:
  Progress();
  void Show(double fraction, const std::string& what);
  void Clear();

private:
  double Started;
  double Drawn = 0.0;
  bool Terminal;
};
}
