// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/AppliedLooks.h"

#include "looks/LookLights.h"
#include "looks/LookSettings.h"
#include "looks/LookSky.h"
#include "looks/SavedRenderer.h"
#include "looks/Vertical.h"

#include "vtkCommand.h"
#include "vtkGIPass.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace penumbra
{
namespace
{
/// The look of one renderer. It is not kept alive by this, as it announces its own end.
class AppliedLook
{
public:
  AppliedLook(std::string name, const LookDescription& look, vtkRenderer* renderer,
    std::shared_ptr<LookSettings> settings)
    : Name(std::move(name))
    , Look(look)
    , Renderer(renderer)
    , Before(renderer)
    , Settings(std::move(settings))
  {
    if (look.Lights)
    {
      this->Before.SwitchLightsOff();
      this->Lights.emplace(look, renderer);
    }
    if (look.Sky)
    {
      this->Sky.emplace(look, renderer);
    }
    // Now, if this is called at the start of a frame, and in the next frame again, whose camera and props count. Without a
    // camera only then: VTK makes one that shows what is there, so it must not be asked for earlier. The priority is
    // higher than that of the sky's own observer.
    this->StartTag =
      renderer->AddObserver(vtkCommand::StartEvent, this, &AppliedLook::PlaceInFrame, 1.0f);
    if (renderer->IsActiveCameraCreated())
    {
      this->Place();
    }
    this->ShowBackground();
    this->DeleteTag =
      renderer->AddObserver(vtkCommand::DeleteEvent, this, &AppliedLook::ForgetRenderer);
  }

  AppliedLook(const AppliedLook&) = delete;
  AppliedLook& operator=(const AppliedLook&) = delete;

  ~AppliedLook()
  {
    this->Before.RestoreLights();
    if (!this->Renderer)
    {
      return;
    }
    this->Renderer->RemoveObserver(this->StartTag);
    this->Renderer->RemoveObserver(this->DeleteTag);
    if (this->Sky)
    {
      this->Sky->RemoveFrom(this->Renderer);
    }
    if (this->Lights)
    {
      this->Lights->RemoveFrom(this->Renderer);
    }
    this->Before.Restore(this->Renderer);
  }

  /// Show the look's sky and background again. Those that were set since are restored later.
  void Restore()
  {
    if (this->Sky)
    {
      this->Sky->Restore(this->Renderer);
    }
    if (this->Look.Background && !this->ShowsBackground())
    {
      this->Before.SaveBackground(this->Renderer);
      this->ShowBackground();
    }
  }

  const std::string& GetName() const { return this->Name; }
  const std::shared_ptr<LookSettings>& GetSettings() const { return this->Settings; }

private:
  bool IsGradient() const { return this->Look.Background->Top != this->Look.Background->Bottom; }

  bool ShowsBackground() const
  {
    const auto equals = [](const double* color, const auto& other) {
      return std::equal(other.begin(), other.end(), color);
    };
    return equals(this->Renderer->GetBackground(), this->Look.Background->Bottom) &&
      equals(this->Renderer->GetBackground2(), this->Look.Background->Top) &&
      this->Renderer->GetGradientBackground() == this->IsGradient() &&
      !this->Renderer->GetTexturedBackground();
  }

  void ShowBackground()
  {
    if (this->Look.Background)
    {
      this->Renderer->SetBackground(this->Look.Background->Bottom.data());
      this->Renderer->SetBackground2(this->Look.Background->Top.data());
      this->Renderer->SetGradientBackground(this->IsGradient());
      this->Renderer->TexturedBackgroundOff();
    }
  }

  void PlaceInFrame()
  {
    this->Renderer->RemoveObserver(this->StartTag);
    this->StartTag = 0;
    this->Place();
  }

  void Place()
  {
    const glm::dvec3 up = UpOf(this->Look, this->Renderer);
    if (this->Lights && !this->Look.FollowsCamera)
    {
      this->Lights->Place(this->Renderer, up);
    }
    if (this->Sky)
    {
      this->Sky->Place(this->Look.FollowsCamera, up);
      // Its own observer may not be called any more in this frame.
      this->Sky->Restore(this->Renderer);
    }
  }

  void ForgetRenderer();

  std::string Name;
  LookDescription Look;
  vtkRenderer* Renderer;
  SavedRenderer Before;
  std::optional<LookLights> Lights;
  std::optional<LookSky> Sky;
  std::shared_ptr<LookSettings> Settings;
  unsigned long StartTag = 0;
  unsigned long DeleteTag = 0;
};

/// Never destroyed, as at the end of the process VTK's objects may be gone already.
std::map<vtkRenderer*, std::unique_ptr<AppliedLook>>& Applied()
{
  static auto& looks = *new std::map<vtkRenderer*, std::unique_ptr<AppliedLook>>;
  return looks;
}

void AppliedLook::ForgetRenderer()
{
  vtkRenderer* renderer = this->Renderer;
  this->Renderer = nullptr;
  Applied().erase(renderer); // deletes this
}

std::shared_ptr<LookSettings> SettingsOf(vtkGIPass* pass)
{
  for (const auto& look : Applied())
  {
    if (look.second->GetSettings() && look.second->GetSettings()->GetPass() == pass)
    {
      return look.second->GetSettings();
    }
  }
  return std::make_shared<LookSettings>(pass);
}
}

void ApplyLook(
  const std::string& name, const LookDescription& look, vtkRenderer* renderer, vtkGIPass* pass)
{
  RemoveLook(renderer);
  std::shared_ptr<LookSettings> settings;
  if (pass)
  {
    settings = SettingsOf(pass);
    settings->Apply(look.Techniques);
  }
  Applied()[renderer] = std::make_unique<AppliedLook>(name, look, renderer, std::move(settings));
}

void RemoveLook(vtkRenderer* renderer)
{
  Applied().erase(renderer);
}

void RestoreLook(vtkRenderer* renderer)
{
  const auto found = Applied().find(renderer);
  if (found != Applied().end())
  {
    found->second->Restore();
  }
}

const char* AppliedLookName(vtkRenderer* renderer)
{
  const auto found = Applied().find(renderer);
  return found == Applied().end() ? nullptr : found->second->GetName().c_str();
}
}
