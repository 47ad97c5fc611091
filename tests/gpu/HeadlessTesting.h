// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// Code shared by the tests of vtkHeadlessRenderWindow: small scenes, pixels, and checks of messages.

#pragma once

#include "vtkHeadlessRenderWindow.h"

#include "gpu/GL.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>

namespace penumbra_test
{
using Window = vtkSmartPointer<vtkHeadlessRenderWindow>;

inline Window MakeWindow(int backend, int width = 200, int height = 150)
{
  Window window = Window::New();
  window->SetBackend(backend);
  window->SetSize(width, height);
  return window;
}

inline vtkSmartPointer<vtkActor> MakeSphere(double x, double red, double green, double blue)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(x, 0, 0);
  actor->GetProperty()->SetColor(red, green, blue);
  return actor;
}

inline vtkSmartPointer<vtkRenderer> MakeScene(
  double red = 1, double green = 0.5, double blue = 0.25)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(0.0, 0.2, 0.4);
  renderer->AddActor(MakeSphere(0, red, green, blue));
  renderer->ResetCamera();
  return renderer;
}

using Pixel = std::array<int, 3>;

inline vtkSmartPointer<vtkImageData> Grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->Update();
  return filter->GetOutput();
}

inline Pixel At(vtkImageData* image, int x, int y)
{
  const auto* value = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
  return { value[0], value[1], value[2] };
}

inline Pixel Centre(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  return At(image, size[0] / 2, size[1] / 2);
}

inline const Pixel Background{ 0, 51, 102 };

inline int LargestDifference(vtkImageData* a, vtkImageData* b)
{
  int largest = 0;
  const auto* left = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* right = static_cast<unsigned char*>(b->GetScalarPointer());
  for (vtkIdType i = 0; i < 3 * a->GetNumberOfPoints(); ++i)
  {
    largest = std::max(largest, std::abs(left[i] - right[i]));
  }
  return largest;
}

// Sets an environment variable for one scope, or unsets it if value is null.
class ScopedVariable
{
public:
  ScopedVariable(const char* name, const char* value)
    : Name(name)
  {
    if (const char* previous = std::getenv(name))
    {
      this->Previous = std::make_unique<std::string>(previous);
    }
    Set(name, value);
  }
  ~ScopedVariable() { Set(this->Name.c_str(), this->Previous ? this->Previous->c_str() : nullptr); }

private:
  static void Set(const char* name, const char* value)
  {
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  std::string Name;
  std::unique_ptr<std::string> Previous;
};

// Expects no errors of OpenGL, and that VTK and the drivers write nothing to stderr.
class ExpectSilence
{
public:
  ExpectSilence() { testing::internal::CaptureStderr(); }
  ~ExpectSilence() { EXPECT_EQ("", testing::internal::GetCapturedStderr() + this->Errors); }

  void Watch(vtkHeadlessRenderWindow* window)
  {
    window->Initialize();
    window->MakeCurrent();
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(RecordError, this);
  }

private:
  static void GLAPIENTRY RecordError(
    GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* self)
  {
    if (type == GL_DEBUG_TYPE_ERROR)
    {
      const_cast<ExpectSilence*>(static_cast<const ExpectSilence*>(self))->Errors +=
        std::string(text) + "\n";
    }
  }
  std::string Errors;
};

// Number of objects in the current context. Drivers assign names from 1 upwards and reuse freed ones, so a scan far
// beyond the number of objects that ever exist at the same time finds them all.
inline int CountObjects()
{
  int count = 0;
  for (GLuint name = 1; name < 4096; ++name)
  {
    count += glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) + glIsRenderbuffer(name) +
      glIsVertexArray(name) + glIsProgram(name) + glIsShader(name) + glIsQuery(name) +
      glIsSampler(name);
  }
  return count;
}

inline double ResidentMegabytes()
{
  std::ifstream file("/proc/self/statm");
  long total = 0;
  long resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

struct Backend
{
  int Value;
  const char* Name;
};
inline void PrintTo(const Backend& backend, std::ostream* os)
{
  *os << backend.Name;
}
inline const Backend EGL{ vtkHeadlessRenderWindow::EGL, "EGL" };
inline const Backend OSMesa{ vtkHeadlessRenderWindow::OSMESA, "OSMesa" };

class HeadlessWindow : public testing::TestWithParam<Backend>
{
protected:
  void SetUp() override
  {
    // A machine may have only one backend: Mesa after 25.0 has no OSMesa.
    Window window = MakeWindow(GetParam().Value);
    testing::internal::CaptureStderr();
    const bool available = window->SupportsOpenGL();
    testing::internal::GetCapturedStderr();
    if (!available)
    {
      GTEST_SKIP() << window->GetContextError();
    }
  }
};
}
