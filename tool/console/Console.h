// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Output on stderr: notes, one sentence per failure, and a progress bar.
#pragma once

#include "common/Reporter.h"

#include <chrono>
#include <vector>

namespace penumbra::tool
{
/// Discards the output of libraries on stdout and stderr while a step runs, unless verbose. It would break the JSON on
/// stdout, and the promise of one clear sentence.
class Console : public Reporter
{
public:
  Console();
  ~Console() override;

  void SetQuiet(bool quiet) { this->Quiet = quiet; }
  void SetVerbose(bool verbose) { this->Verbose = verbose; }

  void Note(const std::string& sentence) override;
  /// "penumbra: SENTENCE"
  void Error(const std::string& sentence);

  /// Steps of more than two seconds show a bar with the remaining time if stderr is a terminal.
  void BeginStep(const std::string& what, double limit) override;
  void Advance(double fraction) override;
  void EndStep() override;

private:
  using Clock = std::chrono::steady_clock;

  void Write(const std::string& text);
  void ClearBar();
  void Silence();
  void Restore();

  int Output; ///< copies of stdout and stderr, which are redirected during steps
  int Errors;
  bool Terminal;
  bool Quiet = false;
  bool Verbose = false;
  bool BarShown = false;
  std::vector<std::string> Steps; ///< running steps, outermost first
  Clock::time_point Started;
  Clock::time_point LastBar;
};
}
