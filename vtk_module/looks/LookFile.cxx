// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/LookFile.h"

#include "vtkGIPass.h"
#include "vtkGITechnique.h"

#include <nlohmann/json.hpp>

namespace penumbra
{
namespace
{
using nlohmann::json;

std::string Text(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string Listed(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

/// A JSON object whose keys must all be read. where: its place, such as "the look 'studio'".
class Section
{
public:
  Section(const json& value, std::string where)
    : Value(value)
    , Where(std::move(where))
  {
    if (!value.is_object())
    {
      throw LookError(this->Where + " must be an object, {...}");
    }
  }

  /// The value or nullptr. Makes the key known.
  const json* Find(const std::string& key)
  {
    if (std::find(this->Known.begin(), this->Known.end(), key) == this->Known.end())
    {
      this->Known.push_back(key);
    }
    const auto found = this->Value.find(key);
    return found == this->Value.end() ? nullptr : &*found;
  }

  void Read(const std::string& key, std::string& target)
  {
    if (const json* value = this->Find(key))
    {
      this->Require(value->is_string(), key, *value, "text");
      target = value->get<std::string>();
    }
  }

  void Read(const std::string& key, bool& target)
  {
    if (const json* value = this->Find(key))
    {
      this->Require(value->is_boolean(), key, *value, "true or false");
      target = value->get<bool>();
    }
  }

  void Read(const std::string& key, double& target, double low, double high)
  {
    if (const json* value = this->Find(key))
    {
      const bool inside =
        value->is_number() && value->get<double>() >= low && value->get<double>() <= high;
      this->Require(inside, key, *value, "a number from " + Text(low) + " to " + Text(high));
      target = value->get<double>();
    }
  }

  /// A colour of three numbers.
  void Read(const std::string& key, LookColor& target)
  {
    const json* value = this->Find(key);
    if (!value)
    {
      return;
    }
    bool inside = value->is_array() && value->size() == 3;
    for (std::size_t i = 0; inside && i < 3; ++i)
    {
      const json& channel = (*value)[i];
      inside = channel.is_number() && channel.get<double>() >= 0.0 && channel.get<double>() <= 1.0;
    }
    this->Require(inside, key, *value, "a colour: three numbers from 0 to 1");
    target = value->get<LookColor>();
  }

  /// One of several names. Returns false if the key is absent.
  bool ReadChoice(
    const std::string& key, const std::vector<std::string>& choices, std::size_t& index)
  {
    const json* value = this->Find(key);
    if (!value)
    {
      return false;
    }
    const auto found = value->is_string()
      ? std::find(choices.begin(), choices.end(), value->get<std::string>())
      : choices.end();
    this->Require(found != choices.end(), key, *value, "one of " + Listed(choices));
    index = static_cast<std::size_t>(found - choices.begin());
    return true;
  }

  void Require(
    bool valid, const std::string& key, const json& value, const std::string& expected) const
  {
    if (!valid)
    {
      throw LookError("'" + key + "' of " + this->Where + " is " +
        value.dump(-1, ' ', false, json::error_handler_t::replace) + ": it must be " + expected);
    }
  }

  const std::string& GetWhere() const { return this->Where; }

  /// Refuses keys that nobody has read.
  void Finish() const
  {
    for (const auto& item : this->Value.items())
    {
      if (std::find(this->Known.begin(), this->Known.end(), item.key()) == this->Known.end())
      {
        throw LookError(
          this->Where + " has no key '" + item.key() + "': its keys are " + Listed(this->Known));
      }
    }
  }

private:
  const json& Value;
  std::string Where;
  std::vector<std::string> Known;
};

LookLight ReadLight(const json& value, const std::string& where)
{
  LookLight light;
  Section section(value, where);
  section.Read("elevation", light.Elevation, -90, 90);
  section.Read("azimuth", light.Azimuth, -180, 180);
  section.Read("color", light.Color);
  section.Read("intensity", light.Intensity, 0, 1000);
  section.Read("angle", light.Angle, 0, 90);
  section.Finish();
  return light;
}

std::vector<LookLight> ReadLights(const json& value, Section& look)
{
  look.Require(value.is_array(), "lights", value, "an array, [...]");
  std::vector<LookLight> lights;
  for (const json& item : value)
  {
    lights.push_back(
      ReadLight(item, "light " + std::to_string(lights.size() + 1) + " of " + look.GetWhere()));
  }
  return lights;
}

LookSoftBox ReadBox(const json& value, const std::string& where)
{
  LookSoftBox box;
  Section section(value, where);
  section.Read("elevation", box.Elevation, -90, 90);
  section.Read("azimuth", box.Azimuth, -180, 180);
  section.Read("width", box.Width, 0.1, 170);
  section.Read("height", box.Height, 0.1, 170);
  section.Read("radius", box.Radius, 0, 180);
  section.Read("radiance", box.Radiance, 0, 1e6);
  section.Read("color", box.Color);
  section.Read("softness", box.Softness, 0, 1);
  section.Finish();
  return box;
}

LookSkyDescription ReadSky(const json& value, Section& look)
{
  LookSkyDescription sky;
  Section section(value, "the sky of " + look.GetWhere());
  section.ReadChoice("kind", { "uniform", "gradient", "daylight" }, sky.Kind);
  section.Read("strength", sky.Strength, 0, 1e6);
  section.Read("color", sky.Color);
  section.Read("zenith", sky.Zenith);
  section.Read("horizon", sky.Horizon);
  section.Read("ground", sky.Ground);
  section.Read("ground-albedo", sky.GroundAlbedo);
  section.Read("turbidity", sky.Turbidity, 1, 10);
  section.Read("sun-elevation", sky.SunElevation, -90, 90);
  section.Read("sun-azimuth", sky.SunAzimuth, -180, 180);
  section.Read("sun-strength", sky.SunStrength, 0, 1000);
  section.Read("visible", sky.Visible);
  if (const json* boxes = section.Find("boxes"))
  {
    section.Require(boxes->is_array(), "boxes", *boxes, "an array, [...]");
    for (const json& box : *boxes)
    {
      sky.Boxes.push_back(
        ReadBox(box, "box " + std::to_string(sky.Boxes.size() + 1) + " of " + section.GetWhere()));
    }
  }
  section.Finish();
  return sky;
}

/// A colour, or an object of two.
LookBackground ReadBackground(const json& value, Section& look)
{
  LookBackground background;
  if (!value.is_object())
  {
    look.Read("background", background.Bottom);
    background.Top = background.Bottom;
    return background;
  }
  Section section(value, "the background of " + look.GetWhere());
  section.Read("bottom", background.Bottom);
  background.Top = background.Bottom;
  section.Read("top", background.Top);
  section.Finish();
  return background;
}

std::vector<std::string> TechniqueNames(vtkGIPass* pass)
{
  std::vector<std::string> names;
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    names.emplace_back(pass->GetTechnique(i)->GetName());
  }
  return names;
}

void ReadParameter(Section& section, vtkGITechnique* technique, int index, LookTechnique& settings)
{
  const std::string name = technique->GetParameterName(index);
  const std::string type = technique->GetParameterType(index);
  if (technique->GetNumberOfParameterValues(index) > 0)
  {
    std::vector<std::string> names;
    for (int i = 0; i < technique->GetNumberOfParameterValues(index); ++i)
    {
      names.emplace_back(technique->GetParameterValueName(index, i));
    }
    std::size_t choice = 0;
    if (section.ReadChoice(name, names, choice))
    {
      settings.Parameters[name] = static_cast<double>(choice);
    }
    return;
  }
  const json* value = section.Find(name);
  if (!value)
  {
    return;
  }
  if (type == "bool")
  {
    bool on = false;
    section.Read(name, on);
    settings.Parameters[name] = on ? 1.0 : 0.0;
    return;
  }
  section.Require(type != "int" || value->is_number_integer(), name, *value, "a whole number");
  section.Read(name, settings.Parameters[name], technique->GetParameterMinimum(index),
    technique->GetParameterMaximum(index));
}

LookTechnique ReadTechnique(const json& value, const std::string& where, vtkGITechnique* technique)
{
  LookTechnique settings;
  Section section(value, where);
  if (section.Find("enabled"))
  {
    settings.Enabled.emplace();
    section.Read("enabled", *settings.Enabled);
  }
  for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
  {
    ReadParameter(section, technique, i, settings);
  }
  section.Finish();
  return settings;
}

std::map<std::string, LookTechnique> ReadTechniques(
  const json& value, Section& look, vtkGIPass* pass)
{
  look.Require(value.is_object(), "techniques", value, "an object, {...}");
  const std::vector<std::string> names = TechniqueNames(pass);
  std::map<std::string, LookTechnique> techniques;
  for (const auto& item : value.items())
  {
    if (std::find(names.begin(), names.end(), item.key()) == names.end())
    {
      throw LookError("'techniques' of " + look.GetWhere() + " has no technique '" + item.key() +
        "': there are " + Listed(names));
    }
    techniques[item.key()] = ReadTechnique(
      item.value(), item.key() + " of " + look.GetWhere(), pass->GetTechnique(item.key().c_str()));
  }
  return techniques;
}

json Parse(const std::string& text, const std::string& where)
{
  try
  {
    constexpr bool exceptions = true, comments = true;
    return json::parse(text, nullptr, exceptions, comments);
  }
  catch (const json::parse_error& error)
  {
    // Drop the prefix of "[json.exception.parse_error.101] parse error at line 3, column 5: ...".
    const std::string reason = error.what();
    const auto start = reason.find("] ");
    throw LookError(where +
      " is not valid JSON: " + (start == std::string::npos ? reason : reason.substr(start + 2)));
  }
}
}

LookDescription ReadLook(const std::string& text, const std::string& name, vtkGIPass* pass)
{
  const std::string where = "the look '" + name + "'";
  const json value = Parse(text, where);
  LookDescription look;
  Section section(value, where);
  section.Read("title", look.Title);
  section.Read("description", look.Text);
  std::size_t choice = 0;
  section.ReadChoice("follows", { "camera", "world" }, choice);
  look.FollowsCamera = choice == 0;
  choice = 0;
  section.ReadChoice("up", { "auto", "x", "y", "z" }, choice);
  if (choice > 0)
  {
    look.Up.emplace();
    look.Up->at(choice - 1) = 1.0;
  }
  if (const json* lights = section.Find("lights"))
  {
    look.Lights = ReadLights(*lights, section);
  }
  if (const json* sky = section.Find("sky"))
  {
    look.Sky = ReadSky(*sky, section);
  }
  if (const json* background = section.Find("background"))
  {
    look.Background = ReadBackground(*background, section);
  }
  if (const json* techniques = section.Find("techniques"))
  {
    look.Techniques = ReadTechniques(*techniques, section, pass);
  }
  section.Finish();
  return look;
}
}
