// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameScenes.h"

#include "vtkGIPass.h"
#include "vtkGIShadowMaps.h"
#include "vtkGITechnique.h"
#include "vtkHeadlessRenderWindow.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFlyingEdges3D.h>
#include <vtkLight.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <chrono>
#include <fstream>
#include <stdexcept>

namespace bench
{
namespace
{
constexpr int OcclusionSamples = 32; // default of vtkSSAOPass
constexpr int MapResolution = 1024;  // default of vtkShadowMapBakerPass

vtkGIPass* AddPass(vtkRenderer* renderer)
{
  vtkNew<vtkGIPass> pass;
  pass->GetTechnique("anti-aliasing")
    ->EnabledOff(); // as in stock VTK's windows, which have no multisampling
  renderer->SetPass(pass);
  return pass;
}

void AddLights(vtkRenderer* renderer)
{
  vtkNew<vtkLight> key;
  key->SetLightTypeToSceneLight();
  key->SetPosition(-300.0, 600.0, 500.0);
  key->SetFocalPoint(0.0, 0.0, 0.0);
  key->SetIntensity(0.8);
  renderer->AddLight(key);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.25);
  renderer->AddLight(fill);
}
}

std::vector<Variant> Variants()
{
  const auto nothing = [](vtkActor*) {};
  const auto modify = [](vtkActor* actor) { actor->Modified(); };
  return {
    { "stock", [](vtkRenderer*) {}, nothing },
    { "pass", [](vtkRenderer* renderer) { AddPass(renderer); }, nothing },
    { "stock ssao",
      [](vtkRenderer* renderer) {
        renderer->UseSSAOOn();
        renderer->SetSSAOKernelSize(OcclusionSamples);
        renderer->SetSSAORadius(30.0);
        renderer->SetSSAOBias(0.3);
        renderer->SSAOBlurOn();
      },
      nothing },
    { "pass ssao",
      [](vtkRenderer* renderer) {
        vtkGITechnique* occlusion = AddPass(renderer)->GetTechnique("ambient-occlusion");
        occlusion->EnabledOn();
        occlusion->SetParameter("samples", OcclusionSamples);
      },
      nothing },
    { "stock shadow", [](vtkRenderer* renderer) { renderer->UseShadowsOn(); }, modify },
    { "pass shadow",
      [](vtkRenderer* renderer) {
        vtkGITechnique* shadows = AddPass(renderer)->GetTechnique("shadow-maps");
        shadows->EnabledOn();
        shadows->SetParameter("resolution", MapResolution);
        vtkGIShadowMaps::SafeDownCast(shadows)->AlwaysRedrawOn();
      },
      modify },
  };
}

std::vector<Variant> TechniqueVariants()
{
  const auto nothing = [](vtkActor*) {};
  const auto preset = [](const char* name, const std::string& technique, bool on) {
    return [name, technique, on](vtkRenderer* renderer) {
      vtkGIPass* pass = AddPass(renderer);
      pass->SetPreset(name);
      pass->GetTechnique("anti-aliasing")->EnabledOff();
      if (!technique.empty())
      {
        pass->GetTechnique(technique.c_str())->SetEnabled(on);
      }
    };
  };
  std::vector<Variant> variants;
  for (const char* name : { "off", "fast", "balanced", "high" })
  {
    variants.push_back({ name, preset(name, "", false), nothing });
  }
  vtkNew<vtkGIPass> pass;
  pass->SetPreset("balanced");
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    vtkGITechnique* technique = pass->GetTechnique(i);
    const std::string name = technique->GetName();
    variants.push_back({ "+" + name, preset("off", name, true), nothing });
    if (technique->GetEnabled())
    {
      variants.push_back({ "-" + name, preset("balanced", name, false), nothing });
    }
  }
  return variants;
}

std::vector<Cost> Costs(const std::vector<Variant>& variants)
{
  std::vector<Cost> costs;
  for (const auto& variant : variants)
  {
    if (variant.Name[0] == '+')
    {
      costs.push_back({ variant.Name.substr(1) + " by itself", variant.Name, "off" });
    }
    else if (variant.Name[0] == '-')
    {
      costs.push_back({ variant.Name.substr(1) + " in balanced", "balanced", variant.Name });
    }
  }
  return costs;
}

vtkSmartPointer<vtkPolyData> ReadHead(const std::string& file, double isovalue)
{
  if (!std::ifstream(file))
  {
    throw std::runtime_error(file +
      " cannot be read; install Debian's mricron-data, or name "
      "another NIfTI volume with --volume=FILE.");
  }
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  surface->SetValue(0, isovalue);
  surface->Update();
  return surface->GetOutput();
}

Stage::Stage(const Variant& variant, vtkPolyData* surface, int width, int height)
  : Drawing(variant)
  , Window(vtkSmartPointer<vtkHeadlessRenderWindow>::New())
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Actor(vtkSmartPointer<vtkActor>::New())
{
  this->Window->SetSize(width, height);
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.9, 0.92, 0.95);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetColor(0.9, 0.75, 0.65);
  this->Renderer->AddActor(this->Actor);
  AddLights(this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(-1.0, 2.0, 0.3);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCamera();
  camera->Zoom(1.4);
  this->Drawing.Prepare(this->Renderer);
}

Stage::~Stage() = default;

double Stage::DrawFrame()
{
  this->Renderer->GetActiveCamera()->Azimuth(1.0);
  return this->RepeatFrame();
}

double Stage::RepeatFrame()
{
  this->Drawing.Touch(this->Actor);
  const auto begin = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
}
