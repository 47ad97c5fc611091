// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/LookSky.h"

#include "looks/Vertical.h"

#include "vtkGISkySource.h"
#include "vtkGISoftBox.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"

namespace penumbra
{
namespace
{
/// Azimuths of looks are counted from the viewer to the right, those of a sky in the world are compass bearings, with north
/// behind the scene.
double SkyAzimuth(double azimuth, bool followsCamera)
{
  return followsCamera ? azimuth : 180.0 - azimuth;
}

void AddBox(const LookSoftBox& described, bool followsCamera, vtkGISkySource* sky)
{
  vtkNew<vtkGISoftBox> box;
  box->SetElevation(described.Elevation);
  box->SetAzimuth(SkyAzimuth(described.Azimuth, followsCamera));
  box->SetWidth(described.Width);
  box->SetHeight(described.Height);
  box->SetRadius(described.Radius);
  box->SetRadiance(described.Radiance);
  box->SetColor(described.Color[0], described.Color[1], described.Color[2]);
  box->SetSoftness(described.Softness);
  sky->AddSoftBox(box);
}

/// Samples of VTK's textures of reflections. VTK takes 1024 and 512, for pictures with small suns; a studio sky is smooth.
/// Without a GPU the difference is seconds in the first frame.
constexpr unsigned int TableSamples = 128;
constexpr unsigned int ReflectionSamples = 64;

vtkOpenGLRenderer* WithTextures(vtkRenderer* renderer)
{
  return vtkOpenGLRenderer::SafeDownCast(renderer);
}
}

LookSky::LookSky(const LookDescription& look, vtkRenderer* renderer)
  : Sky(vtkSmartPointer<vtkGISkySource>::New())
{
  const LookSkyDescription& described = *look.Sky;
  vtkGISkySource* sky = this->Sky;
  const auto set = [sky](void (vtkGISkySource::*setter)(double, double, double),
                     const LookColor& c) { (sky->*setter)(c[0], c[1], c[2]); };
  sky->SetKind(static_cast<int>(described.Kind));
  sky->SetStrength(described.Strength);
  set(&vtkGISkySource::SetColor, described.Color);
  set(&vtkGISkySource::SetZenithColor, described.Zenith);
  set(&vtkGISkySource::SetHorizonColor, described.Horizon);
  set(&vtkGISkySource::SetGroundColor, described.Ground);
  set(&vtkGISkySource::SetGroundAlbedo, described.GroundAlbedo);
  sky->SetTurbidity(described.Turbidity);
  sky->SetSunElevation(described.SunElevation);
  sky->SetSunAzimuth(SkyAzimuth(described.SunAzimuth, look.FollowsCamera));
  sky->SetSunStrength(described.SunStrength);
  sky->SetVisible(described.Visible);
  for (const LookSoftBox& box : described.Boxes)
  {
    AddBox(box, look.FollowsCamera, sky);
  }
  vtkOpenGLRenderer* textured = WithTextures(renderer);
  if (textured && !textured->GetUseImageBasedLighting())
  {
    this->Samples = { textured->GetEnvMapLookupTable()->GetLUTSamples(),
      textured->GetEnvMapPrefiltered()->GetPrefilterMaxSamples() };
    textured->GetEnvMapLookupTable()->SetLUTSamples(TableSamples);
    textured->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(ReflectionSamples);
  }
  sky->ApplyTo(renderer);
}

void LookSky::Place(bool followsCamera, const glm::dvec3& up)
{
  const glm::dvec3 north = -FrontOf(up);
  this->Sky->SetFollowCamera(followsCamera);
  this->Sky->SetUp(up.x, up.y, up.z);
  this->Sky->SetNorth(north.x, north.y, north.z);
}

void LookSky::Restore(vtkRenderer* renderer) const
{
  this->Sky->ApplyTo(renderer);
}

void LookSky::RemoveFrom(vtkRenderer* renderer) const
{
  this->Sky->RemoveFrom(renderer);
  if (this->Samples[0] > 0)
  {
    WithTextures(renderer)->GetEnvMapLookupTable()->SetLUTSamples(this->Samples[0]);
    WithTextures(renderer)->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(this->Samples[1]);
  }
}
}
