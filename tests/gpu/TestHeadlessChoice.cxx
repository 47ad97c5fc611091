// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkHeadlessRenderWindow with other windows, backends, threads and contexts, when it replaces VTK's own window, and
// its errors if no context can be created.

#include "HeadlessTesting.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOutputWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <cstdio>
#include <dlfcn.h>
#include <sys/wait.h>
#include <thread>

using namespace penumbra_test;

namespace
{
INSTANTIATE_TEST_SUITE_P(Backends, HeadlessWindow, testing::Values(EGL, OSMesa),
  [](const auto& info) { return info.param.Name; });

bool IsAvailable(const Backend& backend)
{
  Window window = MakeWindow(backend.Value);
  testing::internal::CaptureStderr();
  const bool available = window->SupportsOpenGL();
  testing::internal::GetCapturedStderr();
  return available;
}

//------------------------------------------------------------------------------
TEST_P(HeadlessWindow, WindowsTakeTurns)
{
  ExpectSilence silence;
  Window red = MakeWindow(GetParam().Value);
  Window green = MakeWindow(GetParam().Value, 120, 90);
  silence.Watch(red);
  silence.Watch(green);
  red->AddRenderer(MakeScene(1, 0, 0));
  green->AddRenderer(MakeScene(0, 1, 0));
  for (int i = 0; i < 5; ++i)
  {
    red->Render();
    green->Render();
    EXPECT_TRUE(green->IsCurrent());
    EXPECT_FALSE(red->IsCurrent());
    EXPECT_NEAR(255, Centre(Grab(red))[0], 3);
    EXPECT_NEAR(255, Centre(Grab(green))[1], 3);
  }
  // Deleting a window leaves the other one current and intact.
  green->Render();
  red = nullptr;
  EXPECT_TRUE(green->IsCurrent());
  EXPECT_NEAR(255, Centre(Grab(green))[1], 3);
}

TEST(HeadlessBackends, TakeTurns)
{
  if (!IsAvailable(EGL) || !IsAvailable(OSMesa))
  {
    GTEST_SKIP() << "needs both backends";
  }
  ExpectSilence silence;
  Window egl = MakeWindow(EGL.Value);
  Window osmesa = MakeWindow(OSMesa.Value);
  silence.Watch(egl);
  silence.Watch(osmesa);
  egl->AddRenderer(MakeScene(1, 0, 0));
  osmesa->AddRenderer(MakeScene(0, 1, 0));
  for (int i = 0; i < 5; ++i)
  {
    egl->Render();
    EXPECT_TRUE(egl->IsCurrent());
    EXPECT_FALSE(osmesa->IsCurrent());
    osmesa->Render();
    EXPECT_TRUE(osmesa->IsCurrent());
    EXPECT_FALSE(egl->IsCurrent());
    EXPECT_NEAR(255, Centre(Grab(egl))[0], 3);
    EXPECT_NEAR(255, Centre(Grab(osmesa))[1], 3);
  }
  egl = nullptr;
  EXPECT_NEAR(255, Centre(Grab(osmesa))[1], 3);
  // A window can change its backend.
  osmesa->SetBackendToEGL();
  EXPECT_STREQ("EGL", osmesa->GetBackendName());
  EXPECT_NEAR(255, Centre(Grab(osmesa))[1], 3);
}

TEST_P(HeadlessWindow, RendererMovesToAnotherWindow)
{
  ExpectSilence silence;
  auto renderer = MakeScene();
  Window first = MakeWindow(GetParam().Value);
  Window second = MakeWindow(GetParam().Value);
  silence.Watch(first);
  silence.Watch(second);
  first->AddRenderer(renderer);
  auto before = Grab(first);
  first->RemoveRenderer(renderer);
  second->AddRenderer(renderer);
  EXPECT_EQ(0, LargestDifference(before, Grab(second)));
  first = nullptr;
  EXPECT_EQ(0, LargestDifference(before, Grab(second)));
}

TEST_P(HeadlessWindow, MovesToAnotherThread)
{
  ExpectSilence silence;
  Window window = MakeWindow(GetParam().Value);
  window->AddRenderer(MakeScene());
  window->Render();
  window->ReleaseCurrent();
  int centre = 0;
  std::thread worker([&] {
    centre = Centre(Grab(window))[0];
    window->ReleaseCurrent();
  });
  worker.join();
  EXPECT_NEAR(255, centre, 3);
  EXPECT_NEAR(255, Centre(Grab(window))[0], 3);
}

TEST_P(HeadlessWindow, WindowsInTwoThreads)
{
  const auto draw = [](int* wrong) {
    Window window = MakeWindow(GetParam().Value);
    window->AddRenderer(MakeScene());
    for (int i = 0; i < 10; ++i)
    {
      *wrong += std::abs(Centre(Grab(window))[0] - 255) > 3;
    }
  };
  ExpectSilence silence;
  // The first initialization of VTK and GLEW is not thread-safe.
  draw(std::make_unique<int>(0).get());
  int wrong[2] = { 0, 0 };
  std::thread one(draw, &wrong[0]);
  std::thread two(draw, &wrong[1]);
  one.join();
  two.join();
  EXPECT_EQ(0, wrong[0] + wrong[1]);
}

// PopContext() makes the context of another library current again.
TEST_P(HeadlessWindow, RestoresAForeignContext)
{
  if (!IsAvailable(EGL))
  {
    GTEST_SKIP() << "needs EGL for the foreign context";
  }
  void* library = dlopen("libEGL.so.1", RTLD_LAZY);
  ASSERT_NE(nullptr, library);
  const auto makeCurrent =
    reinterpret_cast<unsigned (*)(void*, void*, void*, void*)>(dlsym(library, "eglMakeCurrent"));
  const auto getCurrent = reinterpret_cast<void* (*)()>(dlsym(library, "eglGetCurrentContext"));
  const auto getSurface = reinterpret_cast<void* (*)(int)>(dlsym(library, "eglGetCurrentSurface"));

  Window owner = MakeWindow(EGL.Value);
  owner->Initialize();
  void* display = owner->GetGenericDisplayId();
  void* foreign = owner->GetGenericContext();
  void* surface = getSurface(0x3059);
  owner->ReleaseCurrent();

  Window window = MakeWindow(GetParam().Value);
  window->AddRenderer(MakeScene());
  window->Render();
  window->ReleaseCurrent();
  ASSERT_TRUE(makeCurrent(display, surface, surface, foreign));
  window->PushContext();
  EXPECT_TRUE(window->IsCurrent());
  window->PopContext();
  EXPECT_EQ(foreign, getCurrent());
  EXPECT_FALSE(window->IsCurrent());
  window = nullptr;
  EXPECT_EQ(foreign, getCurrent());
  makeCurrent(display, nullptr, nullptr, nullptr);
}

//------------------------------------------------------------------------------
std::string NewWindowClass()
{
  vtkSmartPointer<vtkRenderWindow> window;
  window.TakeReference(vtkRenderWindow::New());
  return window ? window->GetClassName() : "none";
}

// Whether vtkRenderWindow::New() returns VTK's own window. VTK may try X first and warn.
bool IsStock()
{
  testing::internal::CaptureStderr();
  const std::string name = NewWindowClass();
  testing::internal::GetCapturedStderr();
  return name != "none" && name != "vtkHeadlessRenderWindow";
}

TEST(HeadlessChoice, ReplacesXWindowsWithoutADisplay)
{
  ScopedVariable backend("PENUMBRA_BACKEND", nullptr);
  ASSERT_TRUE(vtkHeadlessRenderWindow::GetAutomatic()); // set when the module is loaded
  for (const char* display : { "", static_cast<const char*>(nullptr) })
  {
    ScopedVariable variable("DISPLAY", display);
    EXPECT_EQ("vtkHeadlessRenderWindow", NewWindowClass());
    auto interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
    EXPECT_STREQ("vtkGenericRenderWindowInteractor", interactor->GetClassName());
  }
  ScopedVariable variable("DISPLAY", ":99");
  EXPECT_TRUE(IsStock());
}

// A window that the user chose by VTK's own variable is not replaced.
TEST(HeadlessChoice, RespectsVTKsOwnVariable)
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  bool hasSeveral = false;
  for (int i = 0; i < factories->GetNumberOfItems(); ++i)
  {
    auto* factory = vtkObjectFactory::SafeDownCast(factories->GetItemAsObject(i));
    hasSeveral = hasSeveral || factory->HasOverride("vtkRenderWindow", "vtkOpenGLRenderWindow");
  }
  if (!hasSeveral)
  {
    GTEST_SKIP() << "this VTK has only one kind of window";
  }
  ScopedVariable backend("PENUMBRA_BACKEND", nullptr);
  ScopedVariable display("DISPLAY", nullptr);
  EXPECT_EQ("vtkHeadlessRenderWindow", NewWindowClass());
  ScopedVariable chosen("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow");
  EXPECT_EQ("vtkEGLRenderWindow", NewWindowClass());
}

TEST(HeadlessChoice, FollowsTheEnvironment)
{
  for (const char* display : { "", ":99" })
  {
    ScopedVariable variable("DISPLAY", display);
    for (const char* name : { "egl", "osmesa" })
    {
      ScopedVariable backend("PENUMBRA_BACKEND", name);
      EXPECT_EQ("vtkHeadlessRenderWindow", NewWindowClass());
    }
  }
  ScopedVariable variable("DISPLAY", nullptr);
  ScopedVariable backend("PENUMBRA_BACKEND", "x11");
  EXPECT_TRUE(IsStock());
}

TEST(HeadlessChoice, CanBeSwitchedOffAndOn)
{
  ScopedVariable backend("PENUMBRA_BACKEND", "egl");
  vtkHeadlessRenderWindow::SetAutomatic(false);
  EXPECT_FALSE(vtkHeadlessRenderWindow::GetAutomatic());
  EXPECT_TRUE(IsStock());
  vtkHeadlessRenderWindow::EnableAutomatic();
  vtkHeadlessRenderWindow::EnableAutomatic();
  EXPECT_TRUE(vtkHeadlessRenderWindow::GetAutomatic());
  EXPECT_EQ("vtkHeadlessRenderWindow", NewWindowClass());
}

TEST(HeadlessChoice, PrecedesVTKsFactoryEvenIfRegisteredLater)
{
  // VTK asks its factories in their order in the list. Here ours is registered after VTK's own.
  ScopedVariable backend("PENUMBRA_BACKEND", "egl");
  vtkHeadlessRenderWindow::SetAutomatic(false);
  vtkHeadlessRenderWindow::EnableAutomatic();
  EXPECT_EQ("vtkHeadlessRenderWindow", NewWindowClass());
  vtkSmartPointer<vtkObject> object;
  object.TakeReference(vtkObjectFactory::CreateInstance("vtkRenderWindow"));
  EXPECT_STREQ("vtkHeadlessRenderWindow", object->GetClassName());
}

//------------------------------------------------------------------------------
// Use a window that cannot have a context in all the usual ways. Returns the text on stderr.
std::string UseWithoutContext(vtkHeadlessRenderWindow* window)
{
  testing::internal::CaptureStderr();
  auto renderer = MakeScene();
  window->AddRenderer(renderer);
  window->Render();
  window->Render();
  Grab(window);
  EXPECT_FALSE(window->SupportsOpenGL());
  EXPECT_STREQ("", window->GetBackendName());
  EXPECT_STREQ("", window->GetDescription());
  EXPECT_FALSE(window->IsCurrent());
  window->MakeCurrent();
  delete[] window->GetZbufferData(0, 0, 9, 9);
  delete[] window->GetPixelData(0, 0, 9, 9, 1, 0);
  window->SetSize(50, 50);
  window->Start();
  window->Frame();
  window->End();
  const std::string output = testing::internal::GetCapturedStderr();

  // The selector reports an error of its own, but must not draw.
  testing::internal::CaptureStderr();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, 49, 49);
  EXPECT_EQ(nullptr, selector->Select());
  testing::internal::GetCapturedStderr();
  window->RemoveRenderer(renderer);
  return output;
}

void ExpectOneError(
  const std::string& output, vtkHeadlessRenderWindow* window, const char* expected)
{
  const std::string text = window->GetContextError();
  EXPECT_NE(std::string::npos, text.find(expected)) << text;
  EXPECT_EQ('.', text.empty() ? ' ' : text.back()) << text;
  const size_t first = output.find(text);
  EXPECT_NE(std::string::npos, first) << output;
  size_t errors = 0;
  for (size_t at = output.find("ERR|"); at != std::string::npos; at = output.find("ERR|", at + 1))
  {
    ++errors;
  }
  EXPECT_EQ(1u, errors) << output;
  EXPECT_EQ(std::string::npos, output.find("WARN|")) << output;
}

TEST(HeadlessErrors, UnknownBackend)
{
  ScopedVariable backend("PENUMBRA_BACKEND", "vulkan");
  Window window = MakeWindow(vtkHeadlessRenderWindow::AUTO);
  ExpectOneError(UseWithoutContext(window), window, "PENUMBRA_BACKEND is 'vulkan'");

  // VTK's own window does not know the variable, so vtkRenderWindow::New() reports the error, once.
  ScopedVariable display("DISPLAY", ":99");
  testing::internal::CaptureStderr();
  NewWindowClass();
  NewWindowClass();
  const std::string output = testing::internal::GetCapturedStderr();
  const size_t first = output.find("PENUMBRA_BACKEND is 'vulkan'");
  EXPECT_NE(std::string::npos, first) << output;
  EXPECT_EQ(std::string::npos, output.find("PENUMBRA_BACKEND", first + 1)) << output;
}

TEST(HeadlessErrors, UnknownDevice)
{
  if (!IsAvailable(EGL))
  {
    GTEST_SKIP() << "needs EGL";
  }
  Window window = MakeWindow(vtkHeadlessRenderWindow::AUTO);
  window->SetDeviceIndex(99);
  ExpectOneError(UseWithoutContext(window), window, "EGL device 99 does not exist");
  // A new device index makes it try again.
  window->SetDeviceIndex(-1);
  EXPECT_STREQ("", window->GetContextError());
  window->AddRenderer(MakeScene());
  EXPECT_NEAR(255, Centre(Grab(window))[0], 3);

  ScopedVariable device("PENUMBRA_EGL_DEVICE", "first");
  Window other = MakeWindow(EGL.Value);
  ExpectOneError(UseWithoutContext(other), other, "PENUMBRA_EGL_DEVICE is 'first'");
}

TEST(HeadlessBackends, EGLDeviceByIndex)
{
  Window window = MakeWindow(EGL.Value);
  if (!IsAvailable(EGL) || window->GetNumberOfDevices() < 1)
  {
    GTEST_SKIP() << "needs an EGL device";
  }
  ExpectSilence silence;
  window->SetDeviceIndex(window->GetNumberOfDevices() - 1);
  window->AddRenderer(MakeScene());
  EXPECT_NEAR(255, Centre(Grab(window))[0], 3);
}

TEST(HeadlessErrors, XInteractorIsRefused)
{
  ScopedVariable display("DISPLAY", ":99");
  ScopedVariable backend("PENUMBRA_BACKEND", nullptr);
  auto interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
  if (!interactor->IsA("vtkXRenderWindowInteractor"))
  {
    GTEST_SKIP() << "VTK has no X interactor";
  }
  Window window = MakeWindow(vtkHeadlessRenderWindow::AUTO);
  testing::internal::CaptureStderr();
  window->SetInteractor(interactor);
  const std::string output = testing::internal::GetCapturedStderr();
  EXPECT_NE(std::string::npos, output.find("vtkGenericRenderWindowInteractor")) << output;
  EXPECT_EQ(nullptr, window->GetInteractor());
}

// A process looks for the libraries only once. So a machine without them is simulated in a child process: this program,
// with an environment in which the libraries cannot be loaded.
TEST(HeadlessErrors, DISABLED_InChild)
{
  const char* expected = std::getenv("PENUMBRA_TEST_EXPECTED");
  ASSERT_NE(nullptr, expected);
  Window window = MakeWindow(vtkHeadlessRenderWindow::AUTO);
  ExpectOneError(UseWithoutContext(window), window, expected);
  std::printf("%s\n", window->GetContextError());
}

void RunInChild(const std::string& environment, const char* expected)
{
  std::array<char, 4096> self{};
  ASSERT_GT(readlink("/proc/self/exe", self.data(), self.size() - 1), 0);
  const std::string command = environment + " PENUMBRA_TEST_EXPECTED='" + expected + "' '" +
    self.data() + "' --gtest_also_run_disabled_tests --gtest_filter='*DISABLED_InChild' 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(nullptr, pipe);
  std::string output;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), pipe))
  {
    output += line.data();
  }
  const int status = pclose(pipe);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << output;
  EXPECT_NE(std::string::npos, output.find("[  PASSED  ] 1 test")) << output;
}

std::string EmptyLibrariesFolder()
{
  return testing::TempDir() + "penumbra_empty_libraries_" + std::to_string(getpid());
}

// Returns an environment in which these libraries cannot be loaded: empty files of their names come first in the path.
std::string EnvironmentWithout(std::initializer_list<const char*> names)
{
  const std::string folder = EmptyLibrariesFolder();
  std::string command = "rm -rf '" + folder + "' && mkdir -p '" + folder + "'";
  for (const char* name : names)
  {
    command += " && : > '" + folder + "/" + name + "'";
  }
  EXPECT_EQ(0, std::system(command.c_str()));
  const char* previous = std::getenv("LD_LIBRARY_PATH");
  return "LD_LIBRARY_PATH='" + folder + (previous ? std::string(":") + previous : "") + "'";
}

TEST(HeadlessErrors, MissingLibraries)
{
  RunInChild(EnvironmentWithout({ "libEGL.so.1", "libEGL.so" }) + " PENUMBRA_BACKEND=egl",
    "install libegl1");
  RunInChild(EnvironmentWithout({ "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" }) +
      " PENUMBRA_BACKEND=osmesa",
    "install libosmesa6");
  RunInChild(EnvironmentWithout(
               { "libEGL.so.1", "libEGL.so", "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" }) +
      " PENUMBRA_BACKEND=auto",
    "No OpenGL context without a display");
  EXPECT_EQ(0, std::system(("rm -rf '" + EmptyLibrariesFolder() + "'").c_str()));
}

TEST(HeadlessErrors, OpenGLTooOld)
{
  int tested = 0;
  for (const Backend& backend : { EGL, OSMesa })
  {
    Window window = MakeWindow(backend.Value);
    if (IsAvailable(backend) && strstr(window->GetDescription(), "llvmpipe"))
    {
      ++tested;
      RunInChild(std::string("MESA_GL_VERSION_OVERRIDE=4.1 PENUMBRA_BACKEND=") +
          (backend.Value == EGL.Value ? "egl" : "osmesa"),
        "offers OpenGL 4.1 where 4.3 is needed");
    }
  }
  if (tested == 0)
  {
    GTEST_SKIP() << "needs Mesa's llvmpipe";
  }
}
}
