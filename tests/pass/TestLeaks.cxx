// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Windows and renderers that come and go leave nothing behind. PENUMBRA_NIGHTLY=1 asks for 500 windows and 200 renderers.
#include "Scenes.h"

#include "gpu/GL.h"

#include "vtkGITechnique.h"

#include <cstdlib>
#include <malloc.h>
#include <memory>

namespace penumbra_test
{
namespace
{
int Rounds(int nightly, int otherwise)
{
  const char* value = std::getenv("PENUMBRA_NIGHTLY");
  return value && *value && std::string(value) != "0" ? nightly : otherwise;
}

double AllocatedBytes()
{
  return static_cast<double>(mallinfo2().uordblks);
}

double Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// Bytes that a round adds, from the medians of the second and of the last quarter: caches fill before.
double Growth(const std::vector<double>& bytes)
{
  const std::size_t quarter = bytes.size() / 4;
  const auto begin = bytes.begin();
  const double before = Median({ begin + quarter, begin + 2 * quarter });
  const double after = Median({ bytes.end() - quarter, bytes.end() });
  return (after - before) / static_cast<double>(bytes.size() - 2 * quarter);
}

void UseEverything(vtkRenderer* renderer)
{
  vtkNew<vtkGIPass> pass;
  pass->SetPreset("high");
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    pass->GetTechnique(i)->EnabledOn();
  }
  pass->GetTechnique("ddgi")->SetParameter("probes", 27);
  pass->GetTechnique("path-tracing")->SetParameter("samples", 2);
  pass->KeepRadianceOn();
  renderer->SetPass(pass);
}

void ShowWindow(bool lit)
{
  Scene scene(false);
  scene.Window->SetSize(48, 32);
  if (lit)
  {
    UseEverything(scene.Renderer);
  }
  scene.Window->Render();
}

// Names of objects that the current context knows.
int CountObjects()
{
  constexpr GLuint most = 20000;
  int count = 0;
  for (GLuint name = 1; name < most; ++name)
  {
    count += glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) + glIsVertexArray(name) +
      glIsProgram(name) + glIsQuery(name);
  }
  return count;
}
}

TEST(Leaks, WhatStaysIsSeen)
{
  Scene scene(false);
  scene.Window->Render();
  const int objects = CountObjects();
  std::vector<double> bytes;
  std::vector<std::unique_ptr<char[]>> kept;
  for (int round = 0; round < 8; ++round)
  {
    kept.push_back(std::make_unique<char[]>(65536));
    bytes.push_back(AllocatedBytes());
  }
  EXPECT_NEAR(Growth(bytes), 65536.0, 1024.0);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glBindTexture(GL_TEXTURE_2D, 0);
  EXPECT_EQ(CountObjects(), objects + 1);
  glDeleteTextures(1, &texture);
}

TEST(Leaks, WindowsLeaveNothingBehind)
{
  const int rounds = Rounds(500, 8);
  std::vector<double> bytes[2];
  for (int lit = 0; lit < 2; ++lit)
  {
    for (int round = 0; round < rounds; ++round)
    {
      ShowWindow(lit == 1);
      bytes[lit].push_back(AllocatedBytes());
    }
  }
  // What a window of stock VTK leaves, the driver's part among it, is not ours.
  const double stock = Growth(bytes[0]);
  const double ours = Growth(bytes[1]);
  std::cout << rounds << " windows: " << stock << " bytes a window by stock VTK, " << ours
            << " with every technique\n";
  EXPECT_LT(ours - std::max(stock, 0.0), 16384.0);
}

TEST(Leaks, RenderersLeaveNothingBehind)
{
  const int rounds = Rounds(200, 24);
  Scene scene(false);
  scene.Window->SetSize(48, 32);
  UseEverything(scene.Renderer);
  std::vector<double> bytes;
  std::vector<int> objects;
  for (int round = 0; round < rounds; ++round)
  {
    {
      vtkRenderer* other = scene.AddRenderer();
      other->SetLayer(1);
      scene.Window->SetNumberOfLayers(2);
      vtkNew<vtkActor> ball;
      ball->SetMapper(scene.Ball->GetMapper());
      other->AddActor(ball);
      // By turns a pass of its own, and one that remembers the other renderer's views, too.
      round % 2 == 0 ? UseEverything(other) : other->SetPass(scene.Renderer->GetPass());
      scene.Window->Render();
      scene.Window->RemoveRenderer(other);
    }
    if (round % 4 < 2)
    {
      scene.Window->Render(); // else the next renderer may lie at the address of this one
    }
    bytes.push_back(AllocatedBytes());
    scene.Window->MakeCurrent();
    objects.push_back(CountObjects());
  }
  std::cout << rounds << " renderers: " << Growth(bytes) << " bytes each, " << objects[rounds / 4]
            << " objects of OpenGL, then " << objects.back() << "\n";
  EXPECT_LE(objects.back(), objects[rounds / 4]);
  EXPECT_LT(Growth(bytes), 4096.0);
}
}
