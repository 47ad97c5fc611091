// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WithoutDisplay.h"

#include "ViewAccess.h"

#include "vtkHeadlessRenderWindow.h"

#include "vtkRemotingCoreConfiguration.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

namespace penumbra
{
namespace
{
bool& SkipsDisplayTests(vtkRemotingCoreConfiguration* configuration);

// The member is private, and ParaView sets it only from its command line (--disable-xdisplay-test). An explicit
// instantiation may name private members.
template <bool vtkRemotingCoreConfiguration::*Member>
struct MemberAccess
{
  friend bool& SkipsDisplayTests(vtkRemotingCoreConfiguration* configuration)
  {
    return configuration->*Member;
  }
};
template struct MemberAccess<&vtkRemotingCoreConfiguration::DisableXDisplayTests>;
}

void AllowDrawingWithoutDisplay()
{
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  if (vtkHeadlessRenderWindow::SafeDownCast(window) && window->SupportsOpenGL())
  {
    SkipsDisplayTests(vtkRemotingCoreConfiguration::GetInstance()) = true;
    PrepareNewWindows();
  }
}
}
