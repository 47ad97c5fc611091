// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The environment of a scene file: a picture or a sky.
#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "scene/file/JsonObject.h"
#include "scene/file/SceneFile.h"

#include <vtkGISoftBox.h>
#include <vtkNew.h>

namespace penumbra::tool
{
namespace
{
using nlohmann::json;

constexpr Bounds ElevationBounds = { -90, 90 };

/// Reads a number, if it is given, and passes it to a setter.
template <typename Target>
void Apply(JsonObject& object, const std::string& key, Bounds bounds, Target* target,
  void (Target::*set)(double))
{
  std::optional<double> value;
  object.Read(key, value, bounds);
  value ? (target->*set)(*value) : void();
}

template <typename Target>
void ApplyColor(JsonObject& object, const std::string& key, Target* target,
  void (Target::*set)(double, double, double))
{
  std::optional<Vec3> color;
  object.ReadColor(key, color);
  color ? (target->*set)((*color)[0], (*color)[1], (*color)[2]) : void();
}

void ReadSun(const json& value, const std::string& where, vtkGISkySource* sky)
{
  JsonObject object(value, where);
  std::optional<double> latitude, longitude, elevation, azimuth;
  std::string time;
  object.Read("elevation", elevation, ElevationBounds);
  object.Read("azimuth", azimuth);
  object.Read("latitude", latitude, ElevationBounds);
  object.Read("longitude", longitude, Bounds{ -360, 360 });
  object.Read("time", time);
  Apply(object, "strength", NotNegative, sky, &vtkGISkySource::SetSunStrength);
  object.Finish();
  elevation ? sky->SetSunElevation(*elevation) : void();
  azimuth ? sky->SetSunAzimuth(*azimuth) : void();
  const bool place = latitude && longitude && !time.empty();
  const bool direction = elevation || azimuth;
  if (!place && (latitude || longitude || !time.empty()))
  {
    FailUsage("{} needs 'latitude', 'longitude' and 'time' together", where);
  }
  if (place && direction)
  {
    FailUsage("{} has both a direction and a place with a time: give one of them", where);
  }
  if (place && !sky->SetSunByTime(*latitude, *longitude, time.c_str()))
  {
    TakeVtkMessages();
    FailUsage("'time' of {} is '{}': it must be a time from 1950 to 2050 such as "
              "2026-06-21T16:00:00Z or 2026-06-21T18:00+02:00",
      where, time);
  }
}

vtkSmartPointer<vtkGISoftBox> ReadBox(const json& value, const std::string& where)
{
  auto box = vtkSmartPointer<vtkGISoftBox>::New();
  JsonObject object(value, where);
  Apply(object, "elevation", ElevationBounds, box.Get(), &vtkGISoftBox::SetElevation);
  Apply(object, "azimuth", Bounds{}, box.Get(), &vtkGISoftBox::SetAzimuth);
  Apply(object, "width", Bounds{ 0.1, 170 }, box.Get(), &vtkGISoftBox::SetWidth);
  Apply(object, "height", Bounds{ 0.1, 170 }, box.Get(), &vtkGISoftBox::SetHeight);
  Apply(object, "radius", Bounds{ 0.05, 180 }, box.Get(), &vtkGISoftBox::SetRadius);
  Apply(object, "radiance", NotNegative, box.Get(), &vtkGISoftBox::SetRadiance);
  Apply(object, "softness", UnitInterval, box.Get(), &vtkGISoftBox::SetSoftness);
  ApplyColor(object, "color", box.Get(), &vtkGISoftBox::SetColor);
  object.Finish();
  return box;
}

/// Reads the keys that the kind of sky has. Others are unknown.
vtkSmartPointer<vtkGISkySource> ReadSky(JsonObject& object)
{
  auto sky = vtkSmartPointer<vtkGISkySource>::New();
  int kind = vtkGISkySource::UNIFORM;
  object.ReadChoice<int>("sky", kind,
    { { "uniform", vtkGISkySource::UNIFORM }, { "gradient", vtkGISkySource::GRADIENT },
      { "daylight", vtkGISkySource::DAYLIGHT } });
  sky->SetKind(kind);
  Apply(object, "strength", NotNegative, sky.Get(), &vtkGISkySource::SetStrength);
  Apply(object, "rotation", Bounds{}, sky.Get(), &vtkGISkySource::SetRotation);
  bool follow = false;
  object.Read("follow-camera", follow);
  sky->SetFollowCamera(follow);
  switch (kind)
  {
    case vtkGISkySource::UNIFORM:
      ApplyColor(object, "color", sky.Get(), &vtkGISkySource::SetColor);
      break;
    case vtkGISkySource::GRADIENT:
      ApplyColor(object, "zenith", sky.Get(), &vtkGISkySource::SetZenithColor);
      ApplyColor(object, "horizon", sky.Get(), &vtkGISkySource::SetHorizonColor);
      ApplyColor(object, "ground", sky.Get(), &vtkGISkySource::SetGroundColor);
      break;
    default:
      Apply(object, "turbidity", Bounds{ 1, 10 }, sky.Get(), &vtkGISkySource::SetTurbidity);
      ApplyColor(object, "ground-albedo", sky.Get(), &vtkGISkySource::SetGroundAlbedo);
      if (const json* sun = object.Find("sun"))
      {
        ReadSun(*sun, "the sun of " + object.Where(), sky);
      }
  }
  object.ForEach("boxes", [&](const json& item, const std::string& where) {
    const auto box = ReadBox(item, where);
    sky->AddSoftBox(box);
  });
  return sky;
}
}

EnvironmentMap ReadEnvironment(const json& value, const std::string& where)
{
  EnvironmentMap environment;
  JsonObject object(value, where);
  object.Read("visible", environment.Visible);
  if (object.Find("sky"))
  {
    environment.Sky = ReadSky(object);
    environment.Sky->SetVisible(environment.Visible);
  }
  object.Read("file", environment.Path);
  object.Finish();
  if (environment.Path.empty() != static_cast<bool>(environment.Sky))
  {
    FailUsage("{} needs one of the keys 'file' and 'sky'", where);
  }
  return environment;
}
}
