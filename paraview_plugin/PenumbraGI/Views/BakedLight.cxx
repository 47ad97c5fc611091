// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BakedLight.h"

#include "vtkGIBakeFile.h"
#include "vtkGIProbeBaker.h"
#include "vtkGISHProbes.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace penumbra
{
void BakedLight::Report(const std::string& problem)
{
  this->Problem = problem;
  if (!problem.empty())
  {
    const char* end = problem.back() == '.' ? "\n" : ".\n";
    vtkOutputWindow::GetInstance()->DisplayErrorText(("Penumbra: " + problem + end).c_str());
  }
}

void BakedLight::SetFile(const std::string& path)
{
  this->FileIsNew = this->FileIsNew || path != this->File;
  this->File = path;
}

void BakedLight::Update(vtkGITechnique* technique)
{
  if (!this->FileIsNew || !technique->GetEnabled())
  {
    return;
  }
  this->FileIsNew = false;
  technique->SetBake(nullptr);
  vtkNew<vtkGIBakeFile> file;
  if (!this->File.empty())
  {
    file->Load(this->File.c_str(), technique);
  }
  this->Report(file->GetLastError());
}

void BakedLight::Bake(vtkGISHProbes* technique, vtkRenderer* renderer, int probes, int samples)
{
  vtkNew<vtkGIProbeBaker> baker;
  baker->SetProbes(probes);
  baker->SetSamples(samples);
  vtkNew<vtkImageData> field;
  const bool baked = baker->Bake(renderer, field);
  baker->ReleaseGraphicsResources(renderer->GetRenderWindow());
  if (!baked)
  {
    this->Report(std::string("the probes cannot be baked: ") + baker->GetLastError());
    return;
  }
  if (!technique->SetBake(field))
  {
    this->Report(std::string("the probes cannot be used: ") + technique->GetBakeError());
    return;
  }
  this->FileIsNew = false;
  vtkNew<vtkGIBakeFile> file;
  const bool saved = this->File.empty() || file->Write(this->File.c_str(), field);
  this->Report(saved ? "" : std::string("the probes are baked, but ") + file->GetLastError());
}
}
