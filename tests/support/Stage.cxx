// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "Messages.h"

#include "vtkAlgorithm.h"

#include <cstring>

namespace penumbra_test
{
namespace
{
// VTK 9.1 does not initialize a renderer's memory of its last size and aspect. At the address of a deleted renderer it
// may find its own size there and keep the wrong aspect. Another pixel aspect makes it compute the aspect again.
void ResetAspect(vtkRenderer* renderer)
{
  renderer->SetPixelAspect(2.0, 1.0);
  renderer->ComputeAspect();
  renderer->SetPixelAspect(1.0, 1.0);
}
}

Stage::Stage(int backend)
  : Window(vtkSmartPointer<vtkHeadlessRenderWindow>::New())
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
{
  this->Window->SetBackend(backend);
  this->Window->SetSize(320, 240);
  this->Window->SetMultiSamples(0);
  this->Renderer->SetBackground(0.2, 0.3, 0.4);
  this->Window->AddRenderer(this->Renderer);
  ResetAspect(this->Renderer);
}

Stage::~Stage() = default;

vtkRenderer* Stage::AddRenderer()
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.4, 0.3, 0.2);
  this->Window->AddRenderer(renderer);
  ResetAspect(renderer);
  return renderer;
}

vtkActor* Stage::Add(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  return this->Add(mapper);
}

vtkActor* Stage::Add(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  return this->Add(mapper);
}

vtkActor* Stage::Add(vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
  this->Renderer->AddActor(actor);
  return actor;
}

void Stage::LookAround(vtkRenderer* renderer)
{
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Azimuth(25.0);
  renderer->GetActiveCamera()->Elevation(20.0);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.2);
}

std::vector<vtkSmartPointer<vtkGIPass>> Stage::SetPasses()
{
  std::vector<vtkSmartPointer<vtkGIPass>> passes;
  vtkRendererCollection* renderers = this->Window->GetRenderers();
  for (int i = 0; i < renderers->GetNumberOfItems(); ++i)
  {
    auto pass = vtkSmartPointer<vtkGIPass>::New();
    static_cast<vtkRenderer*>(renderers->GetItemAsObject(i))->SetPass(pass);
    passes.push_back(pass);
  }
  return passes;
}

bool HasBackend(int backend)
{
  static std::map<int, bool> known;
  const auto found = known.find(backend);
  if (found != known.end())
  {
    return found->second;
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetBackend(backend);
  const bool available = window->SupportsOpenGL() != 0;
  TakeMessages();
  return known[backend] = available;
}

bool IsSoftware(vtkHeadlessRenderWindow* window)
{
  window->Render();
  return std::strstr(window->GetDescription(), "llvmpipe") != nullptr;
}
}
