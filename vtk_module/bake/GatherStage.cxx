// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/GatherStage.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace penumbra
{
GatherStage::GatherStage()
{
  const char* folder = std::getenv("PENUMBRA_SHADER_PATH");
  this->Shaders.SetOverrideFolder(folder ? folder : "");
  this->Guard->SetFree([this] { this->FreeAll(); });
}

GatherStage::~GatherStage()
{
  this->Release();
}

void GatherStage::Release()
{
  this->Guard->Leave();
}

void GatherStage::FreeAll()
{
  this->Rays.ReleaseGraphicsResources();
  this->Lamps.ReleaseGraphicsResources();
  this->Shaders.Release();
  this->Points = Buffer();
  this->Results = Buffer();
  this->Renderer = nullptr;
}

void GatherStage::Prepare(vtkRenderer* renderer)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  auto* window =
    vtkOpenGLRenderWindow::SafeDownCast(renderer ? renderer->GetRenderWindow() : nullptr);
  if (!glRenderer || !window)
  {
    throw std::runtime_error(
      "light is gathered in a renderer that is shown in an OpenGL window: add the "
      "renderer to a render window.");
  }
  if (this->Renderer != renderer)
  {
    this->Release();
  }
  // A window of another program's context, as Qt's widgets have, does not know whether it supports OpenGL.
  if (window->GetNeverRendered() && !window->SupportsOpenGL())
  {
    throw std::runtime_error("light is gathered on the GPU, and no OpenGL context can be made.");
  }
  window->Initialize();
  this->Guard->Enter(window);
  this->Renderer = renderer;
  GLint version[2] = { 0, 0 };
  glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
  glGetIntegerv(GL_MINOR_VERSION, &version[1]);
  if (version[0] * 10 + version[1] < 43)
  {
    throw std::runtime_error("light is gathered with OpenGL 4.3, and this window has " +
      std::to_string(version[0]) + "." + std::to_string(version[1]) + ".");
  }
  this->Rays.Update(renderer);
  this->Lamps.Collect(glRenderer);
  std::vector<Light>& lamps = this->Lamps.Lights();
  const auto kept = std::remove_if(
    lamps.begin(), lamps.end(), [](const Light& lamp) { return lamp.FollowsCamera; });
  this->Following = static_cast<int>(lamps.end() - kept);
  lamps.erase(kept, lamps.end());
  this->Lamps.InWorld(this->Rays.Origin());
  this->Lamps.Upload();
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const glm::dvec3 size(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  // As rays/surface.glsl has it, of a triangle as large as the scene.
  this->Inaccuracy = bounds[0] <= bounds[1] ? 1.3e-6 * glm::length(size) : 0.0;
}

void GatherStage::Run(
  const std::string& shader, Defines variant, const Arguments& given, std::size_t groups)
{
  if (!this->Guard->Window())
  {
    throw std::runtime_error("the window gave up its OpenGL context while light was gathered.");
  }
  const Defines scene = this->Rays.ShaderDefines();
  variant.insert(scene.begin(), scene.end());
  variant.erase("GI_RAY_EDGES"); // lines over what the eye sees
  Arguments offered = this->Rays.ShaderArguments();
  offered.Add(this->Lamps.InWorld(this->Rays.Origin()))
    .Block("GatherPointBlock", this->Points)
    .Block("GatherResultBlock", this->Results, ShaderAccess::Write)
    .Set("eye", glm::vec3(0.0f)) // only headlights ask
    .Set("strategy", 0);
  this->Runner.SetWindow(this->Guard->Window());
  this->Runner.Dispatch(
    this->Shaders.Compute(shader, variant), given, Work::GroupsInRows(groups), offered);
}

void GatherStage::Read(std::vector<float>& values)
{
  this->Runner.BeforeUse(this->Results, GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Results.Get());
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
    static_cast<GLsizeiptr>(values.size() * sizeof(values[0])), values.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

void WorkSize::Took(std::size_t units, double seconds)
{
  // Short enough to stop in, long enough that starting costs nothing.
  constexpr double wanted = 0.1;
  const double factor = std::clamp(wanted / std::max(seconds, 1e-4), 0.25, 4.0);
  // A last, small piece of work tells little.
  if (2 * units > this->Units || factor < 1.0)
  {
    constexpr double most = 1 << 24;
    this->Units =
      static_cast<std::size_t>(std::clamp(factor * static_cast<double>(units), 64.0, most));
  }
}
}
