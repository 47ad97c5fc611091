// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Studio.h"

#include "Shapes.h"

#include "vtkGIPass.h"
#include "vtkGIPathTracing.h"
#include "vtkHeadlessRenderWindow.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkPointData.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace validate
{
Material Matte(double reflectance, double emission)
{
  Material material;
  material.Color = { { reflectance, reflectance, reflectance } };
  material.Emission = emission;
  return material;
}

Material Painted(const Vec3& reflectance)
{
  Material material;
  material.Color = reflectance;
  return material;
}

Material Shiny(double diffuse, double specular, double power)
{
  Material material = Matte(diffuse);
  material.Specular = specular;
  material.Power = power;
  return material;
}

Material Physical(double color, double metallic, double roughness)
{
  Material material = Matte(color);
  material.Model = Material::Pbr;
  material.Metallic = metallic;
  material.Roughness = roughness;
  return material;
}

Studio::Studio()
  : Window(vtkSmartPointer<vtkHeadlessRenderWindow>::New())
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Pass(vtkSmartPointer<vtkGIPass>::New())
  , Tracer(vtkGIPathTracing::SafeDownCast(this->Pass->GetTechnique("path-tracing")))
  , Shaders(this->Pass->GetShaderPath())
{
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Pass->KeepRadianceOn();
  this->Tracer->EnabledOn();
  this->Renderer->SetPass(this->Pass);
}

Studio::~Studio() = default;

std::string Studio::Description() const
{
  return this->Window->GetDescription();
}

void Studio::Clear(int width, int height)
{
  this->Renderer->RemoveAllViewProps();
  this->Renderer->RemoveAllLights();
  this->Renderer->SetEnvironmentTexture(nullptr);
  this->Renderer->UseImageBasedLightingOff();
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  this->Window->SetSize(width, height);
  // Without a light VTK draws surfaces in their plain colours, so add one of intensity zero.
  vtkNew<vtkLight> dark;
  dark->SetLightTypeToSceneLight();
  dark->SetIntensity(0.0);
  this->Renderer->AddLight(dark);
  this->SetBounces(8);
  this->SetStrategy("both");
  this->SetShaders("");
}

void Studio::Add(vtkPolyData* shape, const Material& material, bool culled)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetDiffuseColor(material.Color.data());
  property->SetDiffuse(1.0);
  property->SetAmbientColor(material.Emission, material.Emission, material.Emission);
  property->SetAmbient(1.0);
  property->SetSpecularColor(1.0, 1.0, 1.0);
  property->SetSpecular(material.Specular);
  property->SetSpecularPower(material.Power);
  property->SetBackfaceCulling(culled);
  if (material.Model == Material::Pbr)
  {
    property->SetInterpolationToPBR();
    property->SetMetallic(material.Metallic);
    property->SetRoughness(material.Roughness);
  }
  property->SetLighting(material.Model != Material::Unlit);
  this->Renderer->AddActor(actor);
}

void Studio::AddEnvironment(double radiance, double halfSize)
{
  Material sky = Matte(radiance);
  sky.Model = Material::Unlit;
  const double h = halfSize;
  this->Add(Box({ { -h, -h, -h } }, { { h, h, h } }), sky);
}

void Studio::SetEnvironmentTexture(double radiance)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 2, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  image->GetPointData()->GetScalars()->Fill(radiance);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn(); // required by VTK
  this->Renderer->SetEnvironmentTexture(texture);
  this->Renderer->UseImageBasedLightingOn();
  this->Renderer->SetBackground(radiance, radiance, radiance);
  // Minimal settings, because otherwise VTK's filtering for its own shaders takes longer than the rays.
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Renderer);
  renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(2);
  renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
  renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
  renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.3f);
  renderer->GetEnvMapLookupTable()->SetLUTSize(8);
  renderer->GetEnvMapLookupTable()->SetLUTSamples(8);
}

void Studio::LookParallel(
  const Vec3& eye, const Vec3& target, const Vec3& up, double half, double nearest)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(target.data());
  camera->SetViewUp(up.data());
  camera->SetParallelScale(half);
  camera->SetClippingRange(nearest, nearest + 1000.0);
}

void Studio::Look(const Vec3& eye, const Vec3& target, double angle)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(target.data());
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(angle);
  const double distance = camera->GetDistance();
  camera->SetClippingRange(0.01 * distance, 1e5 * distance); // the surroundings may be far away
}

void Studio::SetBounces(int bounces)
{
  this->Tracer->SetBounces(bounces);
}

void Studio::SetStrategy(const char* strategy)
{
  if (!this->Tracer->SetParameterFromText("strategy", strategy))
  {
    throw std::runtime_error(std::string("the path tracer has no strategy '") + strategy + "'.");
  }
}

void Studio::SetShaders(const std::string& folder)
{
  this->Pass->SetShaderPath(folder.empty() ? this->Shaders.c_str() : folder.c_str());
}

Film Studio::Trace(int samples)
{
  using Clock = std::chrono::steady_clock;
  this->Tracer->SetSamples(samples);
  this->Tracer->Modified(); // to start from scratch even if nothing changed
  this->Window->Render();
  const auto begin = Clock::now();
  while (!this->Tracer->IsFinished(this->Renderer))
  {
    const int taken = this->Tracer->GetSamplesTaken(this->Renderer);
    if (this->Pass->GetLastError()[0] != '\0')
    {
      throw std::runtime_error(this->Pass->GetLastError());
    }
    this->Window->Render();
    if (this->OnProgress)
    {
      this->OnProgress(static_cast<double>(taken) / samples);
    }
  }
  this->Window->WaitForCompletion();

  Film film;
  film.Seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  film.Samples = this->Tracer->GetSamplesTaken(this->Renderer);
  vtkNew<vtkImageData> radiance;
  vtkNew<vtkImageData> squares;
  vtkNew<vtkImageData> surfaces;
  if (!this->Pass->GetRadiance(this->Renderer, radiance) ||
    !this->Pass->GetBuffer(this->Renderer, "path-tracing.encoded", squares) ||
    !this->Pass->GetBuffer(this->Renderer, "path-tracing.albedo", surfaces))
  {
    throw std::runtime_error("the pass did not keep the radiance of its frames.");
  }
  const int* size = radiance->GetDimensions();
  film.Width = size[0];
  film.Height = size[1];
  const auto* colors = static_cast<const float*>(radiance->GetScalarPointer());
  const auto* squared = static_cast<const float*>(squares->GetScalarPointer());
  const auto* coverage = static_cast<const float*>(surfaces->GetScalarPointer());
  for (std::size_t i = 0; i < static_cast<std::size_t>(size[0]) * size[1]; ++i)
  {
    const float* color = colors + 4 * i;
    film.Color.insert(film.Color.end(), color, color + 3);
    film.Luminance.push_back(0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]);
    film.SquareMean.push_back(squared[4 * i + 3] / film.Samples);
    film.Coverage.push_back(coverage[4 * i + 3] / film.Samples);
  }
  return film;
}

void SavePng(const Film& film, const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(film.Width, film.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (float linear : film.Color)
  {
    const double value = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    const double encoded =
      value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
    *bytes++ = static_cast<unsigned char>(std::lround(255.0 * encoded));
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error(file + " cannot be written.");
  }
}
}
