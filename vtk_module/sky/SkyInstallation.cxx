// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sky/SkyInstallation.h"

#include "sky/SkyProp.h"
#include "vtkGISkySource.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"

#include <algorithm>

namespace penumbra
{
namespace
{
// VTK's filtering for its own shaders takes two seconds of a CPU at its default settings, and a tenth with these. The image
// is small and smooth, and so is the table of the reflectance.
constexpr unsigned int MostFilterSamples = 128;
constexpr unsigned int LargestTable = 256;
constexpr unsigned int MostTableSamples = 256;
}

SkyInstallation* SkyInstallation::Install(vtkGISkySource* sky, vtkOpenGLRenderer* renderer)
{
  auto* installed = new SkyInstallation;
  installed->Sky = sky;
  installed->Renderer = renderer;
  auto& before = installed->Before;
  auto* filter = renderer->GetEnvMapPrefiltered();
  auto* table = renderer->GetEnvMapLookupTable();
  before.FilterSamples = filter->GetPrefilterMaxSamples();
  before.TableSize = table->GetLUTSize();
  before.TableSamples = table->GetLUTSamples();
  filter->SetPrefilterMaxSamples(std::min(before.FilterSamples, MostFilterSamples));
  table->SetLUTSize(std::min(before.TableSize, LargestTable));
  table->SetLUTSamples(std::min(before.TableSamples, MostTableSamples));

  installed->Texture->SetColorModeToDirectScalars();
  installed->Texture->InterpolateOn();
  installed->Texture->MipmapOn(); // for reflections of rough surfaces
  installed->Texture->SetInputData(sky->GetImage());
  installed->TakeEnvironment();
  installed->Observer = renderer->AddObserver(vtkCommand::StartEvent, installed);
  installed->UnRegister(); // the renderer has registered it
  installed->Update();
  return installed;
}

void SkyInstallation::TakeEnvironment()
{
  vtkOpenGLRenderer* renderer = this->Renderer;
  auto& before = this->Before;
  if (!this->IsCurrent())
  {
    before.Texture = renderer->GetEnvironmentTexture();
    before.Srgb = renderer->GetEnvMapPrefiltered()->GetConvertToLinear();
    std::copy_n(renderer->GetEnvironmentUp(), 3, before.Up);
    std::copy_n(renderer->GetEnvironmentRight(), 3, before.Right);
    before.Harmonics = renderer->GetUseSphericalHarmonics();
    renderer->SetEnvironmentTexture(this->Texture, false);
    // VTK's other way filters the image on the GPU, which takes longer.
    renderer->UseSphericalHarmonicsOn();
    before.ImageBasedLighting = renderer->GetUseImageBasedLighting();
    renderer->UseImageBasedLightingOn();
  }
  else if (!renderer->GetUseImageBasedLighting())
  {
    before.ImageBasedLighting = false;
    renderer->UseImageBasedLightingOn();
  }
}

SkyInstallation::~SkyInstallation()
{
  if (this->Sky)
  {
    this->Sky->Forget(this);
  }
}

vtkOpenGLRenderer* SkyInstallation::GetRenderer() const
{
  return this->Renderer;
}

bool SkyInstallation::IsCurrent() const
{
  return this->Renderer && this->Renderer->GetEnvironmentTexture() == this->Texture;
}

void SkyInstallation::Show(bool skybox)
{
  if (skybox && !this->Skybox)
  {
    this->Skybox = MakeSkybox(this->Texture);
    this->Renderer->AddActor(this->Skybox);
  }
  else if (!skybox && this->Skybox)
  {
    this->Renderer->RemoveActor(this->Skybox);
    this->Skybox = nullptr;
  }
}

void SkyInstallation::Update()
{
  if (!this->IsCurrent())
  {
    return;
  }
  vtkImageData* image = this->Sky->GetImage();
  if (image != this->Texture->GetInput())
  {
    this->Texture->SetInputData(image);
  }
  double right[3], up[3];
  this->Sky->ComputeAxes(this->Renderer, right, up);
  // The setters do nothing where the axes are the same.
  this->Renderer->SetEnvironmentRight(right);
  this->Renderer->SetEnvironmentUp(up);
  this->Show(this->Sky->GetVisible());
  if (this->Skybox)
  {
    Orient(this->Skybox, right, up);
  }
  vtkLight* sun = this->Sky->GetSun();
  if (sun && !this->Sun)
  {
    this->Renderer->AddLight(sun);
  }
  else if (!sun && this->Sun)
  {
    this->Renderer->RemoveLight(this->Sun);
  }
  this->Sun = sun;
}

void SkyInstallation::Remove()
{
  if (!this->Renderer)
  {
    return;
  }
  const bool current = this->IsCurrent();
  this->Show(false);
  if (this->Sun)
  {
    this->Renderer->RemoveLight(this->Sun);
  }
  if (current)
  {
    this->Renderer->SetEnvironmentTexture(this->Before.Texture, this->Before.Srgb);
    this->Renderer->SetEnvironmentUp(this->Before.Up);
    this->Renderer->SetEnvironmentRight(this->Before.Right);
    this->Renderer->SetUseImageBasedLighting(this->Before.ImageBasedLighting);
    this->Renderer->SetUseSphericalHarmonics(this->Before.Harmonics);
    this->Renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(this->Before.FilterSamples);
    this->Renderer->GetEnvMapLookupTable()->SetLUTSize(this->Before.TableSize);
    this->Renderer->GetEnvMapLookupTable()->SetLUTSamples(this->Before.TableSamples);
  }
  this->Renderer->RemoveObserver(this->Observer);
}

void SkyInstallation::Execute(vtkObject*, unsigned long, void*)
{
  this->Update();
}
}
