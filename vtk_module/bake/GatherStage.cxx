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
  this->TracedScene.ReleaseGraphicsResources();
  this->Lights.ReleaseGraphicsResources();
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
  // A window whose context belongs to another toolkit, such as Qt, cannot tell whether it supports OpenGL.
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
  this->TracedScene.Update(renderer);
  this->Lights.Collect(glRenderer);
  std::vector<Light>& lights = this->Lights.Lights();
  const auto firstFollowing = std::remove_if(
    lights.begin(), lights.end(), [](const Light& light) { return light.FollowsCamera; });
  this->FollowingLights = static_cast<int>(lights.end() - firstFollowing);
  lights.erase(firstFollowing, lights.end());
  this->Lights.InWorld(this->TracedScene.Origin());
  this->Lights.Upload();
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const glm::dvec3 size(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  // The same error as in rays/surface.glsl, for a triangle as large as the scene.
  this->CoordinateError = bounds[0] <= bounds[1] ? 1.3e-6 * glm::length(size) : 0.0;
}

void GatherStage::Run(
  const std::string& shader, Defines variant, const Arguments& arguments, std::size_t groups)
{
  if (!this->Guard->Window())
  {
    throw std::runtime_error("the window gave up its OpenGL context while light was gathered.");
  }
  const Defines scene = this->TracedScene.ShaderDefines();
  variant.insert(scene.begin(), scene.end());
  variant.erase("GI_RAY_EDGES"); // edges are drawn only where the camera sees them
  Arguments offered = this->TracedScene.ShaderArguments();
  offered.Add(this->Lights.InWorld(this->TracedScene.Origin()))
    .Block("GatherPointBlock", this->Points)
    .Block("GatherResultBlock", this->Results, ShaderAccess::Write)
    .Set("eye", glm::vec3(0.0f)) // used by headlights only
    .Set("strategy", 0);
  this->Runner.SetWindow(this->Guard->Window());
  this->Runner.Dispatch(
    this->Shaders.Compute(shader, variant), arguments, Work::GroupsInRows(groups), offered);
}

void GatherStage::Read(std::vector<float>& values)
{
  this->Runner.BeforeUse(this->Results, GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Results.Get());
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
    static_cast<GLsizeiptr>(values.size() * sizeof(values[0])), values.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

void WorkSize::Adapt(std::size_t units, double seconds)
{
  // Short enough to abort soon, long enough that the overhead of a dispatch is negligible.
  constexpr double desiredSeconds = 0.1;
  const double factor = std::clamp(desiredSeconds / std::max(seconds, 1e-4), 0.25, 4.0);
  // The time of a last, small piece of work is not representative.
  if (2 * units > this->Units || factor < 1.0)
  {
    constexpr double maximum = 1 << 24;
    this->Units =
      static_cast<std::size_t>(std::clamp(factor * static_cast<double>(units), 64.0, maximum));
  }
}
}
