// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/file/JsonObject.h"

#include "common/Failure.h"
#include "common/Names.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace penumbra::tool
{
JsonObject::JsonObject(const nlohmann::json& value, std::string where)
  : Value(value)
  , Name(std::move(where))
{
  if (!value.is_object())
  {
    FailUsage("{} must be an object in braces", this->Name);
  }
}

const nlohmann::json* JsonObject::Find(const std::string& key)
{
  if (std::find(this->Known.begin(), this->Known.end(), key) == this->Known.end())
  {
    this->Known.push_back(key);
  }
  const auto found = this->Value.find(key);
  return found == this->Value.end() ? nullptr : &*found;
}

void JsonObject::FailType(const std::string& key, const std::string& type) const
{
  FailUsage("'{}' of {} must be {}", key, this->Name, type);
}

void JsonObject::FailChoice(
  const std::string& key, const std::string& name, const std::vector<std::string>& names) const
{
  FailUsage("{}", UnknownName(key, name, this->Name, names));
}

double JsonObject::Number(const nlohmann::json& value, const std::string& key) const
{
  if (!value.is_number() || !std::isfinite(value.get<double>()))
  {
    this->FailType(key, "a finite number");
  }
  return value.get<double>();
}

void JsonObject::Read(const std::string& key, double& target, Bounds bounds)
{
  if (const auto* value = this->Find(key))
  {
    target = this->Number(*value, key);
    if (target < bounds.Low || target > bounds.High)
    {
      const bool below = target < bounds.Low;
      if (below && bounds.Low == Positive.Low)
      {
        FailUsage("'{}' of {} is {:g}: it must be above 0", key, this->Name, target);
      }
      FailUsage("'{}' of {} is {:g}: it must be {} {:g}", key, this->Name, target,
        below ? "at least" : "at most", below ? bounds.Low : bounds.High);
    }
  }
}

void JsonObject::Read(const std::string& key, int& target, Bounds bounds)
{
  constexpr double most = std::numeric_limits<int>::max();
  double number = target;
  this->Read(key, number, Bounds{ std::max(bounds.Low, -most), std::min(bounds.High, most) });
  if (number != std::floor(number))
  {
    this->FailType(key, "a whole number");
  }
  target = static_cast<int>(number);
}

const nlohmann::json* JsonObject::Find(
  const std::string& key, bool (nlohmann::json::*isType)() const noexcept, const char* type)
{
  const nlohmann::json* value = this->Find(key);
  if (value && !(value->*isType)())
  {
    this->FailType(key, type);
  }
  return value;
}

void JsonObject::Read(const std::string& key, bool& target)
{
  if (const auto* value = this->Find(key, &nlohmann::json::is_boolean, "true or false"))
  {
    target = value->get<bool>();
  }
}

void JsonObject::Read(const std::string& key, std::string& target)
{
  if (const auto* value = this->Find(key, &nlohmann::json::is_string, "a text in quotes"))
  {
    target = value->get<std::string>();
  }
}

void JsonObject::Read(const std::string& key, std::vector<double>& target)
{
  if (const auto* value = this->Find(key))
  {
    target.clear();
    if (value->is_number())
    {
      target.push_back(this->Number(*value, key));
      return;
    }
    if (!value->is_array())
    {
      this->FailType(key, "a list of numbers");
    }
    for (const auto& element : *value)
    {
      target.push_back(this->Number(element, key));
    }
  }
}

void JsonObject::Read(const std::string& key, Vec3& target)
{
  if (this->Find(key))
  {
    std::vector<double> numbers;
    this->Read(key, numbers);
    if (numbers.size() != 3)
    {
      this->FailType(key, "a list of three numbers");
    }
    std::copy(numbers.begin(), numbers.end(), target.begin());
  }
}

void JsonObject::Read(const std::string& key, std::vector<std::string>& target)
{
  this->ForEach(key, [&](const nlohmann::json& value, const std::string&) {
    if (!value.is_string())
    {
      this->FailType(key, "a list of texts in quotes");
    }
    target.push_back(value.get<std::string>());
  });
}

void JsonObject::ReadColor(const std::string& key, Vec3& target)
{
  const auto* value = this->Find(key);
  if (value && value->is_string())
  {
    target = ParseColor(value->get<std::string>(), fmt::format("'{}' of {}", key, this->Name));
  }
  else
  {
    this->Read(key, target);
  }
  for (const double channel : target)
  {
    if (channel < 0)
    {
      this->FailType(key, "a colour of numbers from 0");
    }
  }
}

void JsonObject::ReadColor(const std::string& key, std::optional<Vec3>& target)
{
  if (this->Find(key))
  {
    Vec3 color{};
    this->ReadColor(key, color);
    target = color;
  }
}

void JsonObject::ForEach(const std::string& key,
  const std::function<void(const nlohmann::json& value, const std::string& where)>& read)
{
  if (const auto* list = this->Find(key, &nlohmann::json::is_array, "a list in brackets"))
  {
    // The name of an element is the singular of the key: "object 2 of the scene", "box 1 of the environment".
    const bool sibilant = key.size() > 3 && key.compare(key.size() - 3, 3, "xes") == 0;
    const std::string singular =
      key.back() == 's' ? key.substr(0, key.size() - (sibilant ? 2 : 1)) : key;
    std::size_t index = 0;
    for (const auto& value : *list)
    {
      read(value, fmt::format("{} {} of {}", singular, ++index, this->Name));
    }
  }
}

void JsonObject::Finish() const
{
  for (const auto& entry : this->Value.items())
  {
    if (std::find(this->Known.begin(), this->Known.end(), entry.key()) == this->Known.end())
    {
      FailUsage("{}", UnknownName("key", entry.key(), this->Name, this->Known));
    }
  }
}

Vec3 ParseColor(const std::string& text, const std::string& where)
{
  static const std::map<std::string, Vec3> names = { { "black", { 0, 0, 0 } },
    { "white", { 1, 1, 1 } }, { "gray", { 0.5, 0.5, 0.5 } }, { "red", { 0.8, 0.15, 0.12 } },
    { "green", { 0.2, 0.6, 0.25 } }, { "blue", { 0.15, 0.3, 0.75 } },
    { "ivory", { 0.86, 0.80, 0.72 } }, { "charcoal", { 0.12, 0.13, 0.15 } } };
  if (const auto named = names.find(text); named != names.end())
  {
    return named->second;
  }
  const bool hexadecimal = text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!hexadecimal)
  {
    FailUsage("{} is '{}': it must be a colour: three numbers, #rrggbb, black, white, gray, red, "
              "green, blue, ivory or charcoal",
      where, text);
  }
  const unsigned long bits = std::stoul(text.substr(1), nullptr, 16);
  return { (bits >> 16 & 255) / 255.0, (bits >> 8 & 255) / 255.0, (bits & 255) / 255.0 };
}
}
