// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common/Windows.h"

#include "common/Failure.h"
#include "common/Names.h"
#include "common/VtkMessages.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkOpenGLRenderWindow.h>

#include <cstdlib>
#include <map>
#include <sstream>

namespace penumbra::tool
{
namespace
{
/// The value of a line such as "OpenGL vendor string:  Mesa" in vtkRenderWindow::ReportCapabilities().
std::string FindLine(const std::string& report, const std::string& key)
{
  std::istringstream lines(report);
  std::string line;
  while (std::getline(lines, line))
  {
    if (line.rfind(key, 0) == 0)
    {
      const auto start = line.find_first_not_of(" :", key.size());
      return start == std::string::npos ? "" : line.substr(start);
    }
  }
  return "";
}

void RequireDisplay()
{
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    Fail("there is no X display (DISPLAY is not set): use --backend egl or osmesa, or run under "
         "xvfb-run");
  }
}
}

vtkSmartPointer<vtkRenderWindow> MakeWindow(const std::string& backend)
{
  const std::map<std::string, int> headless = { { "egl", vtkHeadlessRenderWindow::EGL },
    { "osmesa", vtkHeadlessRenderWindow::OSMESA } };
  vtkSmartPointer<vtkRenderWindow> window;
  if (const auto found = headless.find(backend); found != headless.end())
  {
    auto headlessWindow = vtkSmartPointer<vtkHeadlessRenderWindow>::New();
    headlessWindow->SetBackend(found->second);
    window = headlessWindow;
  }
  else if (backend == "auto" || backend == "x11")
  {
    const bool x11 = backend == "x11";
    if (x11)
    {
      RequireDisplay();
      vtkHeadlessRenderWindow::SetAutomatic(false);
    }
    window = vtkSmartPointer<vtkRenderWindow>::New();
    // VTK 9.4 and later create another kind of window if the display cannot be opened.
    if (x11 && !window->IsA("vtkXOpenGLRenderWindow"))
    {
      Fail(
        "no x11 window can be created: the X display '{}' cannot be opened; use --backend egl or "
        "osmesa, or run under xvfb-run",
        std::getenv("DISPLAY"));
    }
  }
  else
  {
    FailUsage("{}", UnknownName("backend", backend, "", { "auto", "egl", "osmesa", "x11" }));
  }
  if (window->IsA("vtkXOpenGLRenderWindow"))
  {
    RequireDisplay();
  }
  window->SetOffScreenRendering(1);
  return window;
}

nlohmann::ordered_json OpenWindow(vtkRenderWindow* window)
{
  TakeVtkMessages();
  auto* headless = vtkHeadlessRenderWindow::SafeDownCast(window);
  const bool works = window->SupportsOpenGL() != 0;
  const VtkMessages messages = TakeVtkMessages();
  if (!works)
  {
    const std::string error = headless ? headless->GetContextError() : "";
    const std::string reason = !error.empty()
      ? error
      : (messages.Errors.empty() ? "no reason is given" : messages.Errors.front());
    Fail("no OpenGL context can be created: {}", reason);
  }
  if (auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    glWindow->Initialize();
  }
  window->MakeCurrent();
  const char* capabilities = window->ReportCapabilities();
  const std::string report = capabilities ? capabilities : "";
  return { { "backend", headless ? headless->GetBackendName() : window->GetClassName() },
    { "vendor", FindLine(report, "OpenGL vendor string") },
    { "renderer", FindLine(report, "OpenGL renderer string") },
    { "version", FindLine(report, "OpenGL version string") } };
}
}
