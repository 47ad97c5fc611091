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

// ParaView sets this only from its command line (--disable-xdisplay-test), and the member is private; what
// is named in an explicit instantiation may be.
template <bool vtkRemotingCoreConfiguration::*Member>
struct Open
{
  friend bool& SkipsDisplayTests(vtkRemotingCoreConfiguration* configuration)
  {
    return configuration->*Member;
  }
};
template struct Open<&vtkRemotingCoreConfiguration::DisableXDisplayTests>;
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
