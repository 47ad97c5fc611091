// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What the user sees on stderr: notes, one sentence per failure, and a progress bar.
#pragma once

#include "common/Reporter.h"

#include <chrono>
#include <vector>

namespace penumbra::tool
{
/// While a step runs, what libraries print on stdout and stderr is discarded, unless verbose: it would
/// break the promise of one clear sentence, and the JSON on stdout.
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

  /// Steps that take over two seconds show a bar with the time left, if stderr is a terminal.
  void BeginStep(const std::string& what, double longest) override;
  void Advance(double fraction) override;
  void EndStep() override;

private:
  using Clock = std::chrono::steady_clock;

  void Write(const std::string& text);
  void ClearBar();
  void Silence();
  void Restore();

  int TrueOutput; ///< a copy of stdout, for when it is silenced
  int TrueError;  ///< a copy of stderr
  bool Terminal;
  bool Quiet = false;
  bool Verbose = false;
  bool BarShown = false;
  std::vector<std::string> Steps; ///< those that run, outermost first
  Clock::time_point Started;
  Clock::time_point Drawn;
};
}
