// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/ShadowBench.h"

#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "scene/build/Techniques.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkGIShadowMaps.h>
#include <vtkGITechnique.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPropCollection.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra::tool
{
namespace
{
using Vector = LitView::Vector;

// A receiver takes at least this share of the brightest one's light: less is not seen.
constexpr float Dimmest = 1e-4f;

double Strength(vtkLight* light)
{
  return light->GetIntensity() * vtkMath::Norm(light->GetDiffuseColor());
}

/// A headlight's shadows hide behind what casts them.
bool CastsShadows(vtkLight* light)
{
  return light->GetSwitch() && !light->LightTypeIsHeadlight() && Strength(light) > 0;
}

bool HasParameter(vtkGITechnique* technique, const std::string& parameter)
{
  for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
  {
    if (parameter == technique->GetParameterName(i))
    {
      return true;
    }
  }
  return false;
}
}

ShadowBench::ShadowBench(
  vtkRenderWindow* window, vtkRenderer* renderer, const TechniqueSettings& settings)
  : Target(window)
  , Renderer(renderer)
  , Before(renderer->GetPass())
  , Illumination(vtkSmartPointer<vtkGIPass>::New())
{
  this->Configure(settings);
  this->ChooseLamp();
  this->HideTranslucent();
  renderer->SetPass(this->Illumination);
}

void ShadowBench::Configure(TechniqueSettings settings)
{
  // One map for the whole scene, unless asked for more: a texel means the same everywhere.
  if (HasParameter(this->Maps(), "cascades"))
  {
    settings.Parameters.insert(settings.Parameters.begin(), { "shadow-maps", "cascades", "1" });
  }
  ApplyTechniques(settings, this->Illumination);
  for (int i = 0; i < this->Illumination->GetNumberOfTechniques(); ++i)
  {
    this->Illumination->GetTechnique(i)->EnabledOff();
  }
  for (const char* size : { "light-angle", "light-radius" })
  {
    for (vtkGITechnique* technique :
      { this->Maps(), this->Illumination->GetTechnique("ray-traced-shadows") })
    {
      if (HasParameter(technique, size))
      {
        technique->SetParameter(size, 0);
      }
    }
  }
  this->Illumination->KeepRadianceOn();
}

void ShadowBench::ChooseLamp()
{
  vtkLightCollection* lights = this->Renderer->GetLights();
  vtkCollectionSimpleIterator cursor;
  lights->InitTraversal(cursor);
  while (vtkLight* light = lights->GetNextLight(cursor))
  {
    this->Switches.emplace_back(light, light->GetSwitch());
    if (CastsShadows(light))
    {
      this->Others += this->Studied ? 1 : 0;
      const bool stronger = !this->Studied || Strength(light) > Strength(this->Studied);
      this->Studied = stronger ? light : this->Studied.Get();
    }
  }
  if (!this->Studied)
  {
    Fail("no light of the scene casts shadows that its camera can see: give one with --light, such "
         "as --light directional:1,1,2");
  }
  for (const auto& [light, on] : this->Switches)
  {
    light->SetSwitch(light == this->Studied || (on && light->LightTypeIsHeadlight()));
  }
}

void ShadowBench::HideTranslucent()
{
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator cursor;
  props->InitTraversal(cursor);
  while (vtkProp* prop = props->GetNextProp(cursor))
  {
    const bool translucent = prop->HasTranslucentPolygonalGeometry() || prop->IsA("vtkVolume");
    if (translucent && prop->GetVisibility())
    {
      prop->VisibilityOff();
      this->Hidden.emplace_back(prop);
    }
  }
}

ShadowBench::~ShadowBench()
{
  for (const auto& [light, on] : this->Switches)
  {
    light->SetSwitch(on);
  }
  for (vtkProp* prop : this->Hidden)
  {
    prop->VisibilityOn();
  }
  this->Illumination->ReleaseGraphicsResources(this->Target);
  this->Renderer->SetPass(this->Before);
}

vtkGITechnique* ShadowBench::Maps() const
{
  return this->Illumination->GetTechnique("shadow-maps");
}

double ShadowBench::Texel() const
{
  return vtkGIShadowMaps::SafeDownCast(this->Maps())->GetTexelWidth();
}

std::vector<float> ShadowBench::Shoot(Shadows shadows)
{
  this->Maps()->SetEnabled(shadows == Shadows::Maps);
  this->Illumination->GetTechnique("ray-traced-shadows")->SetEnabled(shadows == Shadows::Rays);
  this->Target->Render();
  ThrowVtkErrors("rendering failed");
  const char* error = this->Illumination->GetLastError();
  vtkNew<vtkImageData> image;
  if ((error && *error) || !this->Illumination->GetRadiance(this->Renderer, image))
  {
    Fail("rendering failed: {}", error && *error ? error : "the pass kept no radiance");
  }
  int size[3];
  image->GetDimensions(size);
  const float* rows =
    vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars())->GetPointer(0);
  const std::size_t row = 4 * std::size_t(size[0]);
  std::vector<float> shot(row * size[1]);
  for (int y = 0; y < size[1]; ++y) // VTK's first row is the bottom one
  {
    std::copy_n(rows + y * row, row, &shot[(size[1] - 1 - y) * row]);
  }
  return shot;
}

/// The share of the light in the channel that it changes most.
std::vector<float> ShadowBench::Share(const std::vector<float>& shot) const
{
  std::vector<float> share(shot.size() / 4, 1.0f);
  for (std::size_t i = 0; i < share.size(); ++i)
  {
    float light = 0;
    for (std::size_t j = 4 * i; j < 4 * i + 3; ++j)
    {
      if (this->Open[j] - this->Unlit[j] > light)
      {
        light = this->Open[j] - this->Unlit[j];
        share[i] = std::clamp((shot[j] - this->Unlit[j]) / light, 0.0f, 1.0f);
      }
    }
  }
  return share;
}

/// World coordinates of the centre of each pixel's surface; not finite where there is none.
std::vector<Vector> ShadowBench::ReadPlaces() const
{
  const int* size = this->Target->GetSize();
  const int width = size[0], height = size[1];
  vtkNew<vtkFloatArray> depths;
  this->Target->GetZbufferData(0, 0, width - 1, height - 1, depths);
  vtkMatrix4x4* toClip = this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    this->Renderer->GetTiledAspectRatio(), -1, 1);
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(toClip, toWorld);
  std::vector<Vector> places(std::size_t(width) * height);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const double depth = depths->GetValue(vtkIdType(y) * width + x);
      double p[4] = { (x + 0.5) / width * 2 - 1, (y + 0.5) / height * 2 - 1, 2 * depth - 1, 1 };
      toWorld->MultiplyPoint(p, p);
      Vector& place = places[std::size_t(height - 1 - y) * width + x];
      place.fill(std::numeric_limits<double>::quiet_NaN());
      if (depth < 1 && p[3] != 0)
      {
        place = { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
      }
    }
  }
  return places;
}

/// The lines of a light's rays, as points of a plane across them, or of the sphere around a lamp.
void ShadowBench::PlaceAcross(LitView& view)
{
  Vector origin, target;
  this->Studied->GetTransformedPosition(origin.data());
  this->Studied->GetTransformedFocalPoint(target.data());
  Vector axis;
  vtkMath::Subtract(target.data(), origin.data(), axis.data());
  vtkMath::Normalize(axis.data());
  const double texel = this->Texel();
  const bool positional = this->Studied->GetPositional() != 0;
  std::vector<double> widths;
  for (std::size_t i = 0; i < view.PixelCount(); ++i)
  {
    Vector& across = view.Across[i];
    vtkMath::Subtract(view.Place[i].data(), origin.data(), across.data());
    double distance = vtkMath::Norm(across.data());
    const double along = vtkMath::Dot(across.data(), axis.data());
    for (int k = 0; k < 3; ++k)
    {
      across[k] = (positional ? across[k] / distance : across[k] - along * axis[k]) / texel;
    }
    if (view.Receiver[i])
    {
      widths.push_back(positional ? distance * texel : texel);
    }
  }
  std::nth_element(widths.begin(), widths.begin() + widths.size() / 2, widths.end());
  this->MiddleTexel = widths[widths.size() / 2];
}

LitView ShadowBench::TraceTruth()
{
  // Off, the light would leave VTK with none, which draws plain colours.
  const double intensity = this->Studied->GetIntensity();
  this->Studied->SetIntensity(0);
  this->Unlit = this->Shoot(Shadows::None);
  this->Studied->SetIntensity(intensity);
  this->Open = this->Shoot(Shadows::None);
  LitView view;
  view.Width = this->Target->GetSize()[0];
  view.Height = this->Target->GetSize()[1];
  view.Place = this->ReadPlaces();
  view.Across.resize(view.PixelCount());
  view.Surface.resize(view.PixelCount());
  view.Receiver.resize(view.PixelCount());
  view.Light.resize(view.PixelCount());
  for (std::size_t i = 0; i < view.PixelCount(); ++i)
  {
    view.Surface[i] = std::isfinite(view.Place[i][0]) && this->Open[4 * i + 3] > 0;
    for (std::size_t j = 4 * i; view.Surface[i] && j < 4 * i + 3; ++j)
    {
      view.Light[i] = std::max(view.Light[i], this->Open[j] - this->Unlit[j]);
    }
  }
  const float brightest = *std::max_element(view.Light.begin(), view.Light.end());
  if (brightest <= 0)
  {
    Fail(
      "the light shines on nothing in view, so that there is no shadow to study: turn the camera "
      "with --camera or give another light with --light");
  }
  for (std::size_t i = 0; i < view.PixelCount(); ++i)
  {
    view.Receiver[i] = view.Light[i] > Dimmest * brightest;
    view.Light[i] = std::min(view.Light[i], 1.0f); // brighter is no whiter
  }
  this->DrawMask(); // so that the map's texel is known
  this->PlaceAcross(view);
  view.Truth = this->Share(this->Shoot(Shadows::Rays));
  return view;
}

std::vector<float> ShadowBench::DrawMask()
{
  return this->Share(this->Shoot(Shadows::Maps));
}

void ShadowBench::ShowTruth()
{
  this->Shoot(Shadows::Rays);
}
}
