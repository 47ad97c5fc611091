// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIPass.h"

#include "gpu/ScopedState.h"
#include "graph/FrameExecutor.h"
#include "base/ScopeExit.h"
#include "pass/PassInternals.h"
#include "pass/StockStages.h"

#include "vtkImageData.h"
#include "vtkRenderState.h"

#include <cstring>

vtkStandardNewMacro(vtkGIPass);

namespace
{
constexpr std::array<const char*, 5> PresetNames = { { "off", "fast", "balanced", "high",
  "reference" } };
}

vtkGIPass::vtkGIPass()
  : Impl(new Internals)
{
  this->SetPreset("off");
  const char* folder = std::getenv("PENUMBRA_SHADER_PATH");
  this->SetShaderPath(folder ? folder : "");
}

vtkGIPass::~vtkGIPass()
{
  delete[] this->Preset;
}

void vtkGIPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "FrameBudget: " << this->FrameBudget << " ms\n";
  for (int i = 0; i < this->GetNumberOfTechniques(); ++i)
  {
    os << indent << this->GetTechnique(i)->GetName() << ":\n";
    this->GetTechnique(i)->PrintSelf(os, indent.GetNextIndent());
  }
}

int vtkGIPass::GetNumberOfPresets()
{
  return static_cast<int>(PresetNames.size());
}

const char* vtkGIPass::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? PresetNames[index] : nullptr;
}

bool vtkGIPass::SetPreset(const char* preset)
{
  const auto known = std::find_if(PresetNames.begin(), PresetNames.end(),
    [preset](const char* name) { return preset && std::strcmp(name, preset) == 0; });
  if (known == PresetNames.end())
  {
    vtkErrorMacro(<< "there is no preset '" << (preset ? preset : "")
                  << "': choose off, fast, balanced, high or reference.");
    return false;
  }
  for (auto& technique : this->Impl->Techniques)
  {
    technique->ApplyPreset(preset);
  }
  delete[] this->Preset;
  this->Preset = new char[std::strlen(preset) + 1];
  std::strcpy(this->Preset, preset);
  this->Modified();
  return true;
}

bool vtkGIPass::SetFrameBudget(double milliseconds)
{
  // Also false for no number.
  if (milliseconds != 0.0 && !(milliseconds >= 1.0 && milliseconds <= MaximumFrameBudget))
  {
    vtkErrorMacro(<< "a frame budget of " << milliseconds
                  << " ms is not possible: it must be from 1 to 10000, or 0 for none.");
    return false;
  }
  if (milliseconds != this->FrameBudget)
  {
    this->FrameBudget = milliseconds;
    this->Modified();
  }
  return true;
}

double vtkGIPass::CurrentFrameBudget(vtkRenderWindow* window) const
{
  const double rate = window->GetDesiredUpdateRate();
  return this->UseDesiredUpdateRate && rate > 1.0 ? std::max(1e3 / rate, 1.0) : this->FrameBudget;
}

void vtkGIPass::ShareFrameBudget(
  vtkRenderer* renderer, const std::function<void(double* values, int count)>& maximum)
{
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  if (window && this->CurrentFrameBudget(window) > 0.0)
  {
    this->Impl->ShareBudget(this, renderer, maximum);
  }
}

int vtkGIPass::GetNumberOfTechniques()
{
  return static_cast<int>(this->Impl->Techniques.size());
}

vtkGITechnique* vtkGIPass::GetTechnique(int index)
{
  const bool inside = index >= 0 && index < this->GetNumberOfTechniques();
  return inside ? this->Impl->Techniques[index].Get() : nullptr;
}

vtkGITechnique* vtkGIPass::GetTechnique(const char* name)
{
  for (auto& technique : this->Impl->Techniques)
  {
    if (name && std::strcmp(technique->GetName(), name) == 0)
    {
      return technique;
    }
  }
  return nullptr;
}

void vtkGIPass::SetShaderPath(const char* path)
{
  const std::string folder = path ? path : "";
  if (folder != this->Impl->ShaderPath)
  {
    this->Impl->ShaderPath = folder;
    this->Modified();
  }
}

const char* vtkGIPass::GetShaderPath()
{
  return this->Impl->ShaderPath.c_str();
}

const char* vtkGIPass::GetStatistics()
{
  return this->Impl->ReadStatistics().c_str();
}

const char* vtkGIPass::GetNotes()
{
  return this->Impl->Notes.c_str();
}

const char* vtkGIPass::GetLastError()
{
  return this->Impl->LastError.c_str();
}

void vtkGIPass::Restart()
{
  this->Impl->Restart();
}

int vtkGIPass::GetAccumulatedFrames(vtkRenderer* renderer)
{
  const auto* record = this->Impl->FindRecord(renderer);
  return record ? record->StillFrames : 0;
}

bool vtkGIPass::HasLoweredSettings(vtkRenderer* renderer)
{
  const auto* record = this->Impl->FindRecord(renderer);
  return record && record->Budget.HasLowered();
}

bool vtkGIPass::GetRadiance(vtkRenderer* renderer, vtkImageData* image)
{
  return this->Impl->ReadRadiance(renderer, image);
}

bool vtkGIPass::GetBuffer(vtkRenderer* renderer, const char* name, vtkImageData* image)
{
  return name && this->Impl->ReadHistory(renderer, name, image);
}

void vtkGIPass::Render(const vtkRenderState* state)
{
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(state->GetRenderer());
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window)
  {
    vtkErrorMacro("vtkGIPass needs an OpenGL render window.");
    return;
  }
  // VTK's translucent stage and its volume mappers report OpenGL errors if there are no pixels.
  int width = 0;
  int height = 0;
  renderer->GetTiledSize(&width, &height);
  if (width <= 0 || height <= 0)
  {
    this->Impl->SkipFrame(renderer);
    this->NumberOfRenderedProps = 0;
    return;
  }
  this->Impl->Enter(window);
  penumbra::RefreshState(window);
  this->Impl->Held.Record(window);
  this->CopiedTile = true;
  const auto draw = [this](const vtkRenderState* picture) {
    this->CopiedTile = false;
    this->RenderPicture(picture);
  };
  if (!this->Impl->ShowTile(state, this->JoinTiles, draw))
  {
    draw(state);
  }
  this->Impl->Held.UnbindOthers(window);
}

void vtkGIPass::RenderPicture(const vtkRenderState* state)
{
  const penumbra::ScopeExit end([this] {
    this->Impl->Placeholder.Remove();
    this->Impl->EndFrame();
  });
  penumbra::StockStages stages(state);
  stages.UpdateCameraAndLights();
  if (stages.RenderSelection())
  {
    this->NumberOfRenderedProps = stages.RenderedProps();
    return;
  }
  std::string problem;
  this->Impl->CapturedProps = 0;
  this->Impl->DrawnByRays = nullptr;
  this->Impl->Forward->ClearLights();
  if (stages.NeedsStockOpaque())
  {
    stages.RenderOpaque();
  }
  else
  {
    problem = this->Impl->RenderFrame(this, state);
    this->Impl->Held.Restore(static_cast<vtkOpenGLRenderer*>(state->GetRenderer())->GetState());
  }
  if (!problem.empty())
  {
    // Fall back to VTK's own drawing, and report each problem once.
    this->Impl->Placeholder.Remove();
    stages.RenderOpaque();
    if (problem != this->Impl->LastError)
    {
      vtkErrorMacro(<< problem);
    }
  }
  this->Impl->LastError = problem;
  if (const auto* rays = problem.empty() ? this->Impl->DrawnByRays : nullptr)
  {
    stages.ExcludeTranslucent([rays](vtkProp* prop) { return rays->Contains(prop); });
  }
  {
    this->Impl->Forward->Attach(state);
    const penumbra::ScopeExit detach([this] { this->Impl->Forward->Detach(); });
    stages.RenderAfterOpaque(this->Impl->CapturedProps, this->Impl->FxaaFilter);
  }
  this->NumberOfRenderedProps = stages.RenderedProps() + this->Impl->CapturedProps;
}

void vtkGIPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->ReleaseGraphicsResources(window);
  if (window) // VTK's class requires one
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}
