// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common/VtkMessages.h"

#include "common/Failure.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <regex>
#include <utility>

namespace penumbra::tool
{
namespace
{
std::mutex Lock;
VtkMessages Collected;

/// "ERROR: In file.cxx, line 12\nvtkFoo (0x123): text\n\n" becomes "text".
std::string Clean(const char* raw)
{
  static const std::regex origin(R"((ERROR|Warning|Generic Warning|Debug): In [^\n]*, line \d+\n)");
  static const std::regex object(R"(vtk\w+ \((0x)?[0-9a-fA-F]+\): ?)");
  std::string text = std::regex_replace(raw ? raw : "", origin, "");
  text = std::regex_replace(text, object, "");
  text = std::regex_replace(text, std::regex(R"(\s+)"), " ");
  const auto first = text.find_first_not_of(' ');
  const auto last = text.find_last_not_of(" .");
  text = first == std::string::npos ? "" : text.substr(first, last - first + 1);
  constexpr std::size_t longest = 240; // enough for the cause, short enough for a sentence
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

void Add(std::vector<std::string>& list, const char* raw)
{
  const std::string text = Clean(raw);
  const std::lock_guard<std::mutex> guard(Lock);
  constexpr std::size_t most = 100; // a damaged file may cause one message per cell
  if (!text.empty() && list.size() < most &&
    std::find(list.begin(), list.end(), text) == list.end())
  {
    list.push_back(text);
  }
}

/// The XML readers report range attributes of NaN as errors, but read the values correctly.
bool IsHarmless(const char* raw)
{
  return raw && std::strstr(raw, "InformationKey element") != nullptr;
}

class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    Add(IsHarmless(text) ? Collected.Harmless : Collected.Errors, text);
  }
  void DisplayWarningText(const char* text) override { Add(Collected.Warnings, text); }
  void DisplayGenericWarningText(const char* text) override { Add(Collected.Warnings, text); }
};
vtkStandardNewMacro(Collector);
}

void CollectVtkMessages()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Collector> collector;
  vtkOutputWindow::SetInstance(collector);
}

VtkMessages TakeVtkMessages()
{
  const std::lock_guard<std::mutex> guard(Lock);
  return std::exchange(Collected, {});
}

void ThrowVtkErrors(const std::string& what)
{
  const VtkMessages messages = TakeVtkMessages();
  if (!messages.Errors.empty())
  {
    Fail("{} ({})", what, messages.Errors.front());
  }
  // Several readers only warn if a file is cut off, and continue with uninitialized values.
  static const std::regex grave(
    "error|fail|premature|unexpected|unable|could not|cannot|corrupt|truncat", std::regex::icase);
  for (const std::string& warning : messages.Warnings)
  {
    if (std::regex_search(warning, grave))
    {
      Fail("{} ({})", what, warning);
    }
  }
}
}
