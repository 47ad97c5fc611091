// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGISkySource.h"

#include "base/Matrices.h"
#include "sky/CheckedValues.h"
#include "sky/MakeSky.h"
#include "sky/SkyInstallation.h"
#include "sky/SunPosition.h"
#include "vtkGILightShape.h"
#include "vtkGISoftBox.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

vtkStandardNewMacro(vtkGISkySource);

vtkGISkySource::vtkGISkySource()
{
  vtkGILightShape::SetAngle(this->Sun, vtkGISkySource::GetSunDiameter());
}

vtkGISkySource::~vtkGISkySource() = default;

void vtkGISkySource::SetStrength(double strength)
{
  SetChecked(this, "Strength", this->Strength, strength, 0.0, 1e6);
}

void vtkGISkySource::SetColor(double r, double g, double b)
{
  SetCheckedColor(this, "Color", this->Color, r, g, b);
}

void vtkGISkySource::SetZenithColor(double r, double g, double b)
{
  SetCheckedColor(this, "ZenithColor", this->ZenithColor, r, g, b);
}

void vtkGISkySource::SetHorizonColor(double r, double g, double b)
{
  SetCheckedColor(this, "HorizonColor", this->HorizonColor, r, g, b);
}

void vtkGISkySource::SetGroundColor(double r, double g, double b)
{
  SetCheckedColor(this, "GroundColor", this->GroundColor, r, g, b);
}

void vtkGISkySource::SetTurbidity(double turbidity)
{
  SetChecked(this, "Turbidity", this->Turbidity, turbidity, 1.0, 10.0);
}

void vtkGISkySource::SetGroundAlbedo(double r, double g, double b)
{
  SetCheckedColor(
    this, "GroundAlbedo", this->GroundAlbedo, std::min(r, 1.0), std::min(g, 1.0), std::min(b, 1.0));
}

void vtkGISkySource::SetSunElevation(double degrees)
{
  SetChecked(this, "SunElevation", this->SunElevation, degrees, -90.0, 90.0);
}

void vtkGISkySource::SetSunAzimuth(double degrees)
{
  SetChecked(this, "SunAzimuth", this->SunAzimuth, degrees, -1e6, 1e6);
}

void vtkGISkySource::SetSunStrength(double strength)
{
  SetChecked(this, "SunStrength", this->SunStrength, strength, 0.0, 1000.0);
}

void vtkGISkySource::SetRotation(double degrees)
{
  SetChecked(this, "Rotation", this->Rotation, degrees, -1e6, 1e6);
}

void vtkGISkySource::SetImageWidth(int width)
{
  const int even = std::clamp(width, 16, 2048) / 4 * 4;
  if (even != this->ImageWidth)
  {
    this->ImageWidth = even;
    this->Modified();
  }
}

namespace
{
void SetAxis(vtkObject* self, const char* name, double (&member)[3], const glm::dvec3& axis)
{
  const double length = glm::length(axis);
  if (!std::isfinite(length) || length < 1e-100)
  {
    vtkErrorWithObjectMacro(
      self, << name << " must be a finite vector other than 0; it is left unchanged.");
  }
  else if (ToVec3(member) != axis)
  {
    std::copy_n(&axis[0], 3, member);
    self->Modified();
  }
}

glm::dvec3 Level(const glm::dvec3& axis, const glm::dvec3& up)
{
  return axis - glm::dot(axis, up) * up;
}
}

void vtkGISkySource::SetUp(double x, double y, double z)
{
  SetAxis(this, "Up", this->Up, { x, y, z });
}

void vtkGISkySource::SetNorth(double x, double y, double z)
{
  SetAxis(this, "North", this->North, { x, y, z });
}

bool vtkGISkySource::SetSunByTime(double latitude, double longitude, const char* time)
{
  double days = 0.0;
  if (!(std::abs(latitude) <= 90.0 && std::abs(longitude) <= 360.0))
  {
    vtkErrorMacro("There is no place at latitude " << latitude << ", longitude " << longitude
                                                   << ": give -90 to 90, and -360 to 360 degrees.");
    return false;
  }
  if (!ParseTime(time, days))
  {
    vtkErrorMacro("'" << (time ? time : "")
                      << "' is no time from 1950 to 2050 in the form "
                         "2026-06-21T16:00:00Z or 2026-06-21T18:00+02:00.");
    return false;
  }
  const SunPosition sun = FindSun(latitude, longitude, days);
  this->SetSunElevation(sun.Elevation + Refraction(sun.Elevation));
  this->SetSunAzimuth(sun.Azimuth);
  return true;
}

void vtkGISkySource::AddSoftBox(vtkGISoftBox* box)
{
  if (!box)
  {
    vtkErrorMacro("AddSoftBox() needs a soft box.");
    return;
  }
  this->SoftBoxes.emplace_back(box);
  this->Modified();
}

void vtkGISkySource::RemoveSoftBox(vtkGISoftBox* box)
{
  const auto found = std::find(this->SoftBoxes.begin(), this->SoftBoxes.end(), box);
  if (found != this->SoftBoxes.end())
  {
    this->SoftBoxes.erase(found);
    this->Modified();
  }
}

void vtkGISkySource::RemoveAllSoftBoxes()
{
  this->SoftBoxes.clear();
  this->Modified();
}

int vtkGISkySource::GetNumberOfSoftBoxes()
{
  return static_cast<int>(this->SoftBoxes.size());
}

vtkGISoftBox* vtkGISkySource::GetSoftBox(int index)
{
  return index >= 0 && index < this->GetNumberOfSoftBoxes()
    ? this->SoftBoxes[static_cast<std::size_t>(index)]
    : nullptr;
}

vtkMTimeType vtkGISkySource::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkGISoftBox* box : this->SoftBoxes)
  {
    time = std::max(time, box->GetMTime());
  }
  return time;
}

// Orientation, visibility and sun strength are not part of it: they change no pixel.
std::vector<double> vtkGISkySource::DescribeImage()
{
  std::vector<double> numbers = { double(this->Kind), this->Strength, double(this->ImageWidth),
    double(this->FollowCamera) };
  const auto add = [&](const double* values, int count) {
    numbers.insert(numbers.end(), values, values + count);
  };
  switch (this->Kind)
  {
    case UNIFORM:
      add(this->Color, 3);
      break;
    case GRADIENT:
      add(this->ZenithColor, 3);
      add(this->HorizonColor, 3);
      add(this->GroundColor, 3);
      break;
    default:
      add(this->GroundAlbedo, 3);
      for (const double value : { this->Turbidity, this->SunElevation, this->SunAzimuth })
      {
        numbers.push_back(value);
      }
  }
  for (vtkGISoftBox* box : this->SoftBoxes)
  {
    for (const double value : { box->GetElevation(), box->GetAzimuth(), box->GetWidth(),
           box->GetHeight(), box->GetRadius(), box->GetRadiance(), box->GetSoftness() })
    {
      numbers.push_back(value);
    }
    add(box->GetColor(), 3);
  }
  return numbers;
}

void vtkGISkySource::Make()
{
  const std::vector<double> wanted = this->DescribeImage();
  if (this->Image && wanted == this->MadeOf)
  {
    return;
  }
  this->MadeOf = wanted;
  const bool compass = !this->FollowCamera;
  SkyImage sky(this->ImageWidth);
  glm::dvec3 sun(0.0);
  switch (this->Kind)
  {
    case UNIFORM:
      sky.Fill([&](const glm::dvec3&) { return this->Strength * ToVec3(this->Color); });
      break;
    case GRADIENT:
      FillGradient(sky, this->Strength * ToVec3(this->ZenithColor),
        this->Strength * ToVec3(this->HorizonColor), this->Strength * ToVec3(this->GroundColor));
      break;
    default:
      sun = FillDaylight(sky, this->Turbidity, ToVec3(this->GroundAlbedo),
        SkyDirection(this->SunElevation, this->SunAzimuth, compass), this->Strength);
  }
  std::copy_n(&sun[0], 3, this->SunAtGround);
  for (vtkGISoftBox* box : this->SoftBoxes)
  {
    SkyBox shape;
    shape.Elevation = box->GetElevation();
    shape.Azimuth = box->GetAzimuth();
    shape.Width = box->GetWidth();
    shape.Height = box->GetHeight();
    shape.Radius = box->GetRadius();
    shape.Softness = box->GetSoftness();
    shape.Radiance = box->GetRadiance() * ToVec3(box->GetColor());
    sky.Add(shape, compass);
  }
  this->Image = vtkSmartPointer<vtkImageData>::New();
  this->Image->SetDimensions(sky.GetWidth(), sky.GetHeight(), 1);
  this->Image->AllocateScalars(VTK_FLOAT, 3);
  std::copy_n(&sky.GetPixels().front()[0], 3 * sky.GetPixels().size(),
    static_cast<float*>(this->Image->GetScalarPointer()));
}

vtkImageData* vtkGISkySource::GetImage()
{
  this->Make();
  return this->Image;
}

namespace
{
SkyImage ToSky(vtkImageData* image)
{
  return SkyImage(image->GetDimensions()[0], static_cast<float*>(image->GetScalarPointer()));
}
}

void vtkGISkySource::GetRadiance(double elevation, double azimuth, double rgb[3])
{
  const glm::dvec3 radiance =
    ToSky(this->GetImage()).At(SkyDirection(elevation, azimuth, !this->FollowCamera));
  std::copy_n(&radiance[0], 3, rgb);
}

void vtkGISkySource::GetIrradiance(double elevation, double azimuth, double rgb[3])
{
  const glm::dvec3 irradiance =
    ToSky(this->GetImage()).Irradiance(SkyDirection(elevation, azimuth, !this->FollowCamera));
  std::copy_n(&irradiance[0], 3, rgb);
}

vtkLight* vtkGISkySource::GetSun()
{
  if (this->Kind != DAYLIGHT)
  {
    return nullptr;
  }
  this->UpdateSun();
  return this->Sun;
}

void vtkGISkySource::UpdateSun()
{
  this->Make();
  // A light of colour c and intensity i gives a white surface that faces it the radiance c * i.
  const glm::dvec3 color = this->Strength * this->SunStrength * ToVec3(this->SunAtGround);
  const double intensity = std::max({ color.r, color.g, color.b });
  const double scale = intensity > 0.0 ? 1.0 / intensity : 0.0;
  this->Sun->SetColor(color.r * scale, color.g * scale, color.b * scale);
  this->Sun->SetIntensity(intensity);
  this->Sun->SetSwitch(intensity > 0.0);
  glm::dvec3 right, up;
  glm::dvec3 origin; // azimuth 0
  if (this->FollowCamera)
  {
    this->Sun->SetLightTypeToCameraLight();
    right = { 1.0, 0.0, 0.0 };
    up = { 0.0, 1.0, 0.0 };
    origin = { 0.0, 0.0, 1.0 };
  }
  else
  {
    this->Sun->SetLightTypeToSceneLight();
    up = glm::normalize(ToVec3(this->Up));
    this->GetCompass(&right[0], &origin[0]);
  }
  const glm::dvec3 local =
    SkyDirection(this->SunElevation, this->SunAzimuth + this->Rotation, false);
  const glm::dvec3 toSun = local.x * right + local.y * up + local.z * origin;
  this->Sun->SetFocalPoint(0.0, 0.0, 0.0);
  this->Sun->SetPosition(toSun.x, toSun.y, toSun.z);
}

/// Axes toward east and north in the world.
void vtkGISkySource::GetCompass(double east[3], double north[3])
{
  const glm::dvec3 up = glm::normalize(ToVec3(this->Up));
  glm::dvec3 level(0.0);
  for (const glm::dvec3& axis :
    { glm::normalize(ToVec3(this->North)), glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0, 0.0, 0.0) })
  {
    if (glm::length(level) < 1e-6)
    {
      level = Level(axis, up);
    }
  }
  level = glm::normalize(level);
  const glm::dvec3 right = glm::cross(level, up);
  std::copy_n(&right[0], 3, east);
  std::copy_n(&level[0], 3, north);
}

void vtkGISkySource::ComputeAxes(vtkRenderer* renderer, double right[3], double up[3])
{
  glm::dvec3 side, origin, vertical;
  if (this->FollowCamera)
  {
    const glm::dmat4 toView = ToMatrix(renderer->GetActiveCamera()->GetViewTransformMatrix());
    const glm::dmat3 toWorld = glm::transpose(glm::dmat3(toView));
    side = toWorld[0];
    vertical = toWorld[1];
    origin = toWorld[2];
  }
  else
  {
    vertical = glm::normalize(ToVec3(this->Up));
    this->GetCompass(&side[0], &origin[0]);
  }
  const double turn = glm::radians(this->Rotation);
  const glm::dvec3 turned = std::cos(turn) * side - std::sin(turn) * origin;
  std::copy_n(&turned[0], 3, right);
  std::copy_n(&vertical[0], 3, up);
}

SkyInstallation* vtkGISkySource::FindInstallation(vtkRenderer* renderer)
{
  const auto found = std::find_if(this->Installations.begin(), this->Installations.end(),
    [&](SkyInstallation* installed) { return installed->GetRenderer() == renderer; });
  return found == this->Installations.end() ? nullptr : *found;
}

void vtkGISkySource::Forget(SkyInstallation* installation)
{
  this->Installations.erase(
    std::remove(this->Installations.begin(), this->Installations.end(), installation),
    this->Installations.end());
}

void vtkGISkySource::ApplyTo(vtkRenderer* renderer)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  if (!glRenderer)
  {
    vtkErrorMacro("A sky can only be applied to a renderer of VTK's OpenGL backend.");
  }
  else if (SkyInstallation* installed = this->FindInstallation(renderer))
  {
    installed->TakeEnvironment();
    installed->Update();
  }
  else
  {
    this->Installations.push_back(SkyInstallation::Install(this, glRenderer));
  }
}

void vtkGISkySource::RemoveFrom(vtkRenderer* renderer)
{
  SkyInstallation* installed = renderer ? this->FindInstallation(renderer) : nullptr;
  if (installed)
  {
    const vtkSmartPointer<vtkGISkySource> keep(this); // the renderer may hold the last reference
    installed->Remove();
  }
}

bool vtkGISkySource::IsAppliedTo(vtkRenderer* renderer)
{
  return renderer && this->FindInstallation(renderer) != nullptr;
}

void vtkGISkySource::UpdateFor(vtkRenderer* renderer)
{
  if (SkyInstallation* installed = renderer ? this->FindInstallation(renderer) : nullptr)
  {
    installed->Update();
  }
}

void vtkGISkySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->Kind << "\n"
     << indent << "Strength: " << this->Strength << "\n"
     << indent << "Turbidity: " << this->Turbidity << "\n"
     << indent << "Sun: elevation " << this->SunElevation << ", azimuth " << this->SunAzimuth
     << ", strength " << this->SunStrength << "\n"
     << indent << "Soft boxes: " << this->SoftBoxes.size() << "\n"
     << indent << "Rotation: " << this->Rotation << "\n"
     << indent << "FollowCamera: " << this->FollowCamera << "\n"
     << indent << "Visible: " << this->Visible << "\n"
     << indent << "ImageWidth: " << this->ImageWidth << "\n";
}
