// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <string>

namespace penumbra_test
{
namespace
{
std::vector<std::string> Messages;

// The logger records these messages too, so they are not shown here.
class QuietOutput : public vtkOutputWindow
{
public:
  static QuietOutput* New();
  vtkTypeMacro(QuietOutput, vtkOutputWindow);
  void DisplayText(const char*) override {}
};
vtkStandardNewMacro(QuietOutput);

// VTK 9.4 and later forward messages of the driver's compiler, and Mesa warns of this variable in VTK's volume shader,
// with stock VTK too.
bool IsStockWarning(const std::string& message)
{
  return message.find("SOURCE_SHADER_COMPILER") != std::string::npos &&
    message.find("warning: `g_dataPos' used uninitialized") != std::string::npos;
}

void Record(void*, const vtkLogger::Message& message)
{
  if (IsStockWarning(message.message))
  {
    return;
  }
  Messages.push_back(message.message);
}

class FailOnMessages : public testing::EmptyTestEventListener
{
  void OnTestStart(const testing::TestInfo&) override { Messages.clear(); }
  void OnTestEnd(const testing::TestInfo&) override
  {
    for (const auto& message : TakeMessages())
    {
      ADD_FAILURE() << "unexpected: ERR| " << message;
    }
  }
};
}

void WatchMessages()
{
  vtkNew<QuietOutput> output;
  vtkOutputWindow::SetInstance(output);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkLogger::AddCallback("tests", Record, nullptr, vtkLogger::VERBOSITY_WARNING);
  testing::UnitTest::GetInstance()->listeners().Append(new FailOnMessages);
}

std::vector<std::string> TakeMessages()
{
  std::vector<std::string> taken;
  taken.swap(Messages);
  return taken;
}
}
