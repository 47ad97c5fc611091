// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/file/SceneFile.h"

#include "common/Failure.h"
#include "scene/file/JsonObject.h"
#include "scene/readers/Formats.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace penumbra::tool
{
namespace
{
using nlohmann::json;

json Parse(const std::string& path)
{
  RequireReadableFile(path);
  std::ifstream file(path);
  try
  {
    constexpr bool exceptions = true, comments = true;
    return json::parse(file, nullptr, exceptions, comments);
  }
  catch (const json::parse_error& error)
  {
    // Drop the prefix of "[json.exception.parse_error.101] parse error at line 3, column 5: ...".
    const std::string text = error.what();
    const auto start = text.find("] ");
    Fail("the scene file '{}' is not valid JSON: {}", path,
      start == std::string::npos ? text : text.substr(start + 2));
  }
}

/// The text of a parameter's value (a number, text or truth value), which its technique checks.
std::string ValueText(const json& value)
{
  return value.is_string() ? value.get<std::string>()
                           : (value.is_boolean() ? (value.get<bool>() ? "1" : "0") : value.dump());
}

TechniqueSettings ReadTechniques(const json& value, const std::string& where)
{
  TechniqueSettings settings;
  JsonObject object(value, where);
  object.Read("preset", settings.Preset);
  object.Read("on", settings.On);
  object.Read("off", settings.Off);
  if (const json* parameters = object.Find("set"))
  {
    JsonObject checked(*parameters, "'set' of " + where);
    for (const auto& technique : parameters->items())
    {
      JsonObject inner(
        technique.value(), fmt::format("technique '{}' of {}", technique.key(), where));
      for (const auto& parameter : technique.value().items())
      {
        settings.Parameters.push_back(
          { technique.key(), parameter.key(), ValueText(parameter.value()) });
      }
    }
  }
  object.Finish();
  return settings;
}

void MakeAbsolute(std::string& path, const std::filesystem::path& folder)
{
  if (!path.empty())
  {
    path = (folder / path).lexically_normal().string();
  }
}

bool IsLookFile(const std::string& look)
{
  const std::filesystem::path path = look;
  return path.has_parent_path() || path.extension() == ".json";
}

void MakePathsAbsolute(Scene& scene, const std::filesystem::path& folder)
{
  for (Object& object : scene.Objects)
  {
    MakeAbsolute(object.Path, folder);
    if (object.Appearance)
    {
      MakeAbsolute(object.Appearance->Texture, folder);
      MakeAbsolute(object.Appearance->NormalTexture, folder);
      MakeAbsolute(object.Appearance->OrmTexture, folder);
      MakeAbsolute(object.Appearance->EmissionTexture, folder);
    }
  }
  for (std::string& bake : scene.Bakes)
  {
    MakeAbsolute(bake, folder);
  }
  if (IsLookFile(scene.Look))
  {
    MakeAbsolute(scene.Look, folder);
  }
  if (scene.Environment)
  {
    MakeAbsolute(scene.Environment->Path, folder);
  }
}

void ReadSize(JsonObject& object, Scene& scene)
{
  if (object.Find("size"))
  {
    std::vector<double> size;
    object.Read("size", size);
    const bool whole =
      size.size() == 2 && size[0] == std::floor(size[0]) && size[1] == std::floor(size[1]);
    if (!whole || size[0] < 1 || size[1] < 1 || size[0] > 32768 || size[1] > 32768)
    {
      FailUsage("'size' of {} must be two whole numbers from 1 to 32768", object.Where());
    }
    scene.Width = static_cast<int>(size[0]);
    scene.Height = static_cast<int>(size[1]);
  }
}
}

namespace
{
void ReadShape(JsonObject& object, Light& light)
{
  const bool local = light.Kind == LightKind::Point || light.Kind == LightKind::Cone;
  if (light.Kind == LightKind::Directional || light.Kind == LightKind::Key)
  {
    object.Read("angle", light.Diameter, Bounds{ 0, 90 });
  }
  else
  {
    object.Read("angle", light.Angle, Bounds{ 0.1, 89.9 });
  }
  object.Read("radius", light.Radius, NotNegative);
  object.Read("disc", light.Disc, NotNegative);
  object.Read("rectangle", light.Rectangle);
  object.Read("turn", light.Turn);
  const int shapes =
    (light.Radius ? 1 : 0) + (light.Disc ? 1 : 0) + (light.Rectangle.empty() ? 0 : 1);
  if (shapes > 1 || (shapes == 1 && !local))
  {
    FailUsage("{} must be of type point or cone, and have one of 'radius', 'disc' and 'rectangle'",
      object.Where());
  }
  const bool positive = std::all_of(
    light.Rectangle.begin(), light.Rectangle.end(), [](double length) { return length >= 0.0; });
  if (!light.Rectangle.empty() && (light.Rectangle.size() != 2 || !positive))
  {
    FailUsage("'rectangle' of {} must be a width and a height, such as [2, 1]", object.Where());
  }
}
}

Light ReadLight(const json& value, const std::string& where)
{
  Light light;
  JsonObject object(value, where);
  object.ReadChoice<LightKind>("type", light.Kind,
    { { "key", LightKind::Key }, { "head", LightKind::Head },
      { "directional", LightKind::Directional }, { "point", LightKind::Point },
      { "cone", LightKind::Cone } });
  object.Read("position", light.Position);
  object.Read("target", light.Target);
  object.Read("azimuth", light.Azimuth);
  object.Read("elevation", light.Elevation, Bounds{ -90, 90 });
  ReadShape(object, light);
  object.Read("exponent", light.Exponent, Bounds{ 0, 128 });
  object.Read("attenuation", light.Attenuation);
  object.ReadColor("color", light.Color);
  object.Read("intensity", light.Intensity, NotNegative);
  object.Read("on", light.On);
  object.Finish();
  return light;
}

Camera ReadCamera(const json& value, const std::string& where)
{
  Camera camera;
  JsonObject object(value, where);
  object.Read("position", camera.Position);
  object.Read("focal", camera.FocalPoint);
  object.Read("up", camera.ViewUp);
  object.Read("angle", camera.ViewAngle, Bounds{ 0.1, 170 });
  object.Read("azimuth", camera.Azimuth);
  object.Read("elevation", camera.Elevation, Bounds{ -90, 90 });
  object.Read("roll", camera.Roll);
  object.Read("zoom", camera.Zoom, Positive);
  object.Read("parallel", camera.Parallel);
  object.Read("scale", camera.ParallelScale, Positive);
  object.Finish();
  return camera;
}

Background ReadBackground(const json& value, const std::string& where)
{
  Background background;
  if (value == "transparent")
  {
    background.Transparent = true;
    background.Bottom = background.Top = { 0, 0, 0 };
    return background;
  }
  if (!value.is_object())
  {
    const json wrapped = { { "color", value } };
    JsonObject(wrapped, where).ReadColor("color", background.Bottom);
    background.Top = background.Bottom;
    return background;
  }
  JsonObject object(value, where);
  object.ReadColor("bottom", background.Bottom);
  object.ReadColor("top", background.Top);
  object.Read("transparent", background.Transparent);
  object.Finish();
  return background;
}

Scene ReadSceneFile(const std::string& path)
{
  const json value = Parse(path);
  Scene scene;
  JsonObject object(value, fmt::format("the scene '{}'", path));
  object.ForEach("objects", [&](const json& item, const std::string& where) {
    scene.Objects.push_back(ReadObject(item, where));
  });
  if (object.Find("lights"))
  {
    scene.Lights.emplace();
  }
  object.ForEach("lights", [&](const json& item, const std::string& where) {
    scene.Lights->push_back(ReadLight(item, where));
  });
  if (const json* camera = object.Find("camera"))
  {
    scene.View = ReadCamera(*camera, "the camera of " + object.Where());
  }
  if (const json* environment = object.Find("environment"))
  {
    scene.Environment = ReadEnvironment(*environment, "the environment of " + object.Where());
  }
  if (const json* background = object.Find("background"))
  {
    scene.Backdrop = ReadBackground(*background, "the background of " + object.Where());
  }
  if (const json* techniques = object.Find("techniques"))
  {
    scene.Techniques = ReadTechniques(*techniques, "the techniques of " + object.Where());
  }
  object.Read("look", scene.Look);
  ReadSize(object, scene);
  object.Read("frames", scene.Frames, Bounds{ 1, 65536 });
  object.Read("depth-peeling", scene.DepthPeeling);
  object.Read("bakes", scene.Bakes);
  object.Finish();
  MakePathsAbsolute(scene, std::filesystem::absolute(path).parent_path());
  return scene;
}
}
