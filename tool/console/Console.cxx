// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "console/Console.h"

#include "console/Supervisor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace penumbra::tool
{
namespace
{
constexpr auto FirstBar = std::chrono::seconds(2);
constexpr auto BarInterval = std::chrono::milliseconds(100);

/// Messages of libraries may have several lines, and control characters from damaged files.
std::string OneLine(std::string text)
{
  for (char& c : text)
  {
    c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  text.erase(text.find_last_not_of(" .") + 1);
  return text;
}

std::string Bar(const std::string& what, double fraction, double seconds)
{
  constexpr int cells = 30;
  const int filled = static_cast<int>(cells * fraction);
  const double left = fraction > 0.01 ? seconds * (1 - fraction) / fraction : -1;
  const std::string eta = left < 0
    ? ""
    : fmt::format(", {}:{:02} left", static_cast<int>(left) / 60, static_cast<int>(left) % 60);
  return fmt::format("\r{} [{}{}] {:.0f} %{}\x1b[K", what, std::string(filled, '#'),
    std::string(cells - filled, '.'), 100 * fraction, eta);
}
}

Console::Console()
  : Output(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3))
  , Errors(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3))
  , Terminal(isatty(STDERR_FILENO))
{
}

Console::~Console()
{
  close(this->Output);
  close(this->Errors);
}

void Console::Note(const std::string& sentence)
{
  if (!this->Quiet)
  {
    this->ClearBar();
    this->Write(fmt::format("penumbra: note: {}\n", OneLine(sentence)));
  }
}

void Console::Error(const std::string& sentence)
{
  this->ClearBar();
  this->Write(fmt::format("penumbra: {}\n", OneLine(sentence)));
}

void Console::BeginStep(const std::string& what, double limit)
{
  LimitProcessorTime(limit);
  if (this->Steps.empty())
  {
    this->Silence();
  }
  this->Steps.push_back(what);
  SetStage(what);
  this->Started = this->LastBar = Clock::now();
}

void Console::Advance(double fraction)
{
  const auto now = Clock::now();
  const bool due = now - this->Started > FirstBar && now - this->LastBar > BarInterval;
  if (!this->Terminal || this->Quiet || !due || this->Steps.empty())
  {
    return;
  }
  this->LastBar = now;
  this->BarShown = true;
  const double seconds = std::chrono::duration<double>(now - this->Started).count();
  this->Write(Bar(this->Steps.back(), std::clamp(fraction, 0.0, 1.0), seconds));
}

void Console::EndStep()
{
  LimitProcessorTime(0);
  this->ClearBar();
  this->Steps.pop_back();
  SetStage(this->Steps.empty() ? "" : this->Steps.back());
  if (this->Steps.empty())
  {
    this->Restore();
  }
}

void Console::Write(const std::string& text)
{
  std::size_t done = 0;
  while (done < text.size())
  {
    const ssize_t written = write(this->Errors, text.data() + done, text.size() - done);
    if (written <= 0)
    {
      return; // stderr is closed
    }
    done += static_cast<std::size_t>(written);
  }
}

void Console::ClearBar()
{
  if (this->BarShown)
  {
    this->Write("\r\x1b[K");
    this->BarShown = false;
  }
}

void Console::Silence()
{
  const int nothing = this->Verbose ? -1 : open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0)
  {
    std::fflush(nullptr);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    close(nothing);
  }
}

void Console::Restore()
{
  std::fflush(nullptr);
  dup2(this->Output, STDOUT_FILENO);
  dup2(this->Errors, STDERR_FILENO);
}
}
