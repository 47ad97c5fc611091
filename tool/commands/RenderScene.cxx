// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The scene that the options of penumbra render describe.
#include "commands/RenderOptions.h"
#include "common/Failure.h"
#include "scene/build/Materials.h"
#include "scene/file/SceneFile.h"
#include "scene/file/SpecText.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace penumbra::tool
{
namespace
{
bool IsSceneFile(const std::string& path)
{
  return path.size() > 5 && path.compare(path.size() - 5, 5, ".json") == 0;
}

/// ARRAY or ARRAY:COMPONENT; the array's name may contain a colon.
ColorBy ParseColorBy(const RenderOptions& options)
{
  ColorBy color;
  color.Array = options.ColorBy;
  const auto colon = options.ColorBy.rfind(':');
  const std::string end = colon == std::string::npos ? "" : options.ColorBy.substr(colon + 1);
  const bool component = end == "x" || end == "y" || end == "z" || end == "magnitude" ||
    (!end.empty() && end.size() < 4 && end.find_first_not_of("0123456789") == std::string::npos);
  if (component)
  {
    color.Array = options.ColorBy.substr(0, colon);
    color.Component = end;
  }
  color.Map = options.ColorMap.empty() ? color.Map : options.ColorMap;
  color.ScalarBar = options.ScalarBar;
  if (!options.ColorRange.empty())
  {
    const std::vector<double> range = ParseNumbers(options.ColorRange, "--color-range");
    if (range.size() != 2 || range[0] >= range[1])
    {
      FailUsage(
        "--color-range is '{}': it must be two increasing numbers, LOW,HIGH", options.ColorRange);
    }
    color.Range = { range[0], range[1] };
  }
  return color;
}

MoleculeStyle ParseMolecule(const std::string& text)
{
  const nlohmann::json described = { { "sphere", nlohmann::json::object() }, { "molecule", text } };
  return ReadObject(described, "--molecule").Molecule;
}

/// Applies the options on the appearance and treatment of objects.
void ApplyToObject(const RenderOptions& options, Object& object, std::size_t index)
{
  const auto replace = [](auto& target, const auto& value, bool given) {
    if (given)
    {
      target = value;
    }
  };
  replace(object.IsoValues, options.IsoValues, !options.IsoValues.empty());
  replace(object.IsoArray, options.IsoArray, !options.IsoArray.empty());
  replace(object.Opacities, options.Opacities, !options.Opacities.empty());
  replace(object.Smoothing, options.Smoothing.value_or(0), options.Smoothing.has_value());
  replace(object.PointsAsBalls, true, options.Points);
  replace(object.Radius, options.Radius.value_or(0), options.Radius.has_value());
  replace(object.FeatureAngle, options.FeatureAngle, options.FeatureAngle.has_value());
  if (!options.ColorBy.empty())
  {
    object.Color = ParseColorBy(options);
  }
  if (!options.Molecule.empty())
  {
    object.Molecule = ParseMolecule(options.Molecule);
  }
  if (!options.Color.empty())
  {
    object.Appearance =
      object.Appearance.value_or(DefaultMaterial(index, !options.Environment.empty()));
    object.Appearance->Color = ParseColorOption(options.Color, "--color");
  }
  if (options.Terrain || options.Exaggeration || options.Spacing || options.Stride)
  {
    Terrain terrain = object.Heights.value_or(Terrain());
    replace(terrain.Exaggeration, options.Exaggeration, options.Exaggeration.has_value());
    replace(terrain.Spacing, options.Spacing, options.Spacing.has_value());
    terrain.Stride = options.Stride.value_or(terrain.Stride);
    object.Heights = terrain;
  }
}

void ApplySize(const std::string& text, Scene& scene)
{
  constexpr int largest = 32768;
  const auto cross = text.find_first_of("xX");
  const std::string parts[2] = { text.substr(0, cross),
    cross == std::string::npos ? "" : text.substr(cross + 1) };
  for (const std::string& part : parts)
  {
    const bool number =
      !part.empty() && part.size() < 6 && part.find_first_not_of("0123456789") == std::string::npos;
    if (!number || std::stoi(part) < 1 || std::stoi(part) > largest)
    {
      FailUsage("--size is '{}': it must be WIDTHxHEIGHT, each from 1 to {}", text, largest);
    }
  }
  scene.Width = std::stoi(parts[0]);
  scene.Height = std::stoi(parts[1]);
}

/// Refuses light of one's own beside a look, which would switch it off, if both are asked for in the same place.
void RequireOneLight(const RenderOptions& options)
{
  const bool ownLight = !options.Lights.empty() || !options.Environment.empty();
  if (ownLight && !options.Look.empty() && options.Look != OwnLook)
  {
    FailUsage("--look {} replaces the scene's light: give no {} with it", options.Look,
      options.Lights.empty() ? "--env" : "--light");
  }
}

/// The look if none is asked for: none with light of one's own, and none where the picture shall be VTK's.
std::string DefaultLook(const RenderOptions& options, const Scene& scene)
{
  const bool ownLight = scene.Lights || scene.Environment || !scene.Bakes.empty();
  return ownLight || options.Stock || scene.Techniques.Preset == "off" ? OwnLook : "studio";
}

void ApplyTechniqueOptions(const RenderOptions& options, TechniqueSettings& settings)
{
  settings.Preset = options.Preset.empty() ? settings.Preset : options.Preset;
  settings.On.insert(settings.On.end(), options.On.begin(), options.On.end());
  if (options.Denoise)
  {
    settings.On.push_back("denoising");
  }
  settings.Off.insert(settings.Off.end(), options.Off.begin(), options.Off.end());
  for (const std::string& text : options.Set)
  {
    const auto dot = text.find('.'), equals = text.find('=');
    if (dot == std::string::npos || equals == std::string::npos || equals < dot)
    {
      FailUsage(
        "--set is '{}': it must be TECHNIQUE.PARAMETER=VALUE, such as shadow-maps.resolution=4096",
        text);
    }
    settings.Parameters.push_back(
      { text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1) });
  }
  if (options.Samples)
  {
    settings.Parameters.push_back({ "path-tracing", "samples", std::to_string(*options.Samples) });
  }
  if (options.Error)
  {
    settings.Parameters.push_back(
      { "path-tracing", "target-error", fmt::format("{}", *options.Error) });
  }
}
}

Scene MakeScene(const RenderOptions& options)
{
  Scene scene;
  const auto sceneFiles = std::count_if(options.Files.begin(), options.Files.end(), IsSceneFile);
  if (sceneFiles > 0)
  {
    if (options.Files.size() > 1)
    {
      FailUsage("'{}' is a scene file, which describes a complete picture: give no other files",
        *std::find_if(options.Files.begin(), options.Files.end(), IsSceneFile));
    }
    scene = ReadSceneFile(options.Files.front());
  }
  for (const std::string& file : options.Files)
  {
    if (sceneFiles == 0)
    {
      scene.Objects.emplace_back();
      scene.Objects.back().Path = file;
    }
  }
  for (std::size_t i = 0; i < scene.Objects.size(); ++i)
  {
    ApplyToObject(options, scene.Objects[i], i);
  }
  if (!options.Size.empty())
  {
    ApplySize(options.Size, scene);
  }
  for (std::size_t i = 0; i < options.Lights.size(); ++i)
  {
    scene.Lights = i == 0 ? std::vector<Light>() : *scene.Lights;
    scene.Lights->push_back(ReadLight(ParseSpec(options.Lights[i], SpecKind::TypeFirst),
      fmt::format("--light '{}'", options.Lights[i])));
  }
  if (!options.Camera.empty())
  {
    scene.View = ReadCamera(
      ParseSpec(options.Camera, SpecKind::KeysOnly), fmt::format("--camera '{}'", options.Camera));
  }
  if (!options.Environment.empty())
  {
    scene.Environment = EnvironmentMap{ options.Environment, nullptr, false };
  }
  if (options.ShowEnvironment)
  {
    if (!scene.Environment)
    {
      FailUsage("--show-env needs an environment: give --env FILE");
    }
    scene.Environment->Visible = true;
    if (scene.Environment->Sky)
    {
      scene.Environment->Sky->VisibleOn();
    }
  }
  if (!options.Background.empty())
  {
    const bool keys = options.Background.find('=') != std::string::npos;
    const std::string where = fmt::format("--background '{}'", options.Background);
    scene.Backdrop = options.Background == "transparent"
      ? ReadBackground(nlohmann::json("transparent"), where)
      : (keys ? ReadBackground(ParseSpec(options.Background, SpecKind::KeysOnly), where)
              : Background{ ParseColorOption(options.Background, "--background"),
                  ParseColorOption(options.Background, "--background"), false });
  }
  scene.Frames = options.Frames.value_or(scene.Frames);
  ApplyTechniqueOptions(options, scene.Techniques);
  scene.Bakes.insert(scene.Bakes.end(), options.Bakes.begin(), options.Bakes.end());
  RequireOneLight(options);
  scene.Look = options.Look.empty() ? scene.Look : options.Look;
  scene.LookGiven = !scene.Look.empty();
  scene.Look = scene.LookGiven ? scene.Look : DefaultLook(options, scene);
  scene.FramesGiven = options.Frames.has_value();
  return scene;
}
}
