// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/file/SpecText.h"

#include "common/Failure.h"
#include "scene/file/JsonObject.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>

namespace penumbra::tool
{
namespace
{
using nlohmann::json;

std::optional<double> ToNumber(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole = !text.empty() && end == text.c_str() + text.size() && std::isfinite(value);
  return whole ? std::optional<double>(value) : std::nullopt;
}

json ToValue(const std::string& text)
{
  if (text == "true" || text == "false")
  {
    return text == "true";
  }
  const auto number = ToNumber(text);
  return number ? json(*number) : json(text);
}

std::vector<std::string> Split(const std::string& text)
{
  std::vector<std::string> items;
  std::size_t start = 0;
  while (start <= text.size())
  {
    const auto comma = std::min(text.find(',', start), text.size());
    items.push_back(text.substr(start, comma - start));
    start = comma + 1;
  }
  return items;
}
}

json ParseSpec(const std::string& text, SpecKind kind)
{
  json spec = json::object();
  std::string rest = text, key;
  if (kind == SpecKind::TypeFirst)
  {
    const auto colon = text.find(':');
    spec["type"] = text.substr(0, colon);
    rest = colon == std::string::npos ? "" : text.substr(colon + 1);
    key = "position";
  }
  if (rest.empty())
  {
    return spec;
  }
  for (const std::string& item : Split(rest))
  {
    const auto equals = item.find('=');
    if (equals != std::string::npos)
    {
      key = item.substr(0, equals);
      spec[key] = ToValue(item.substr(equals + 1));
    }
    else if (!key.empty() && ToNumber(item))
    {
      // Another number of the previous key: "target=0,0,1".
      json& value = spec[key];
      value = value.is_array() ? value : (value.is_null() ? json::array() : json::array({ value }));
      value.push_back(*ToNumber(item));
    }
    else
    {
      key = item;
      spec[key] = true;
    }
  }
  return spec;
}

std::vector<double> ParseNumbers(const std::string& text, const std::string& where)
{
  std::vector<double> numbers;
  for (const std::string& item : Split(text))
  {
    const auto number = ToNumber(item);
    if (!number)
    {
      FailUsage("{} is '{}': it must be numbers separated by commas", where, text);
    }
    numbers.push_back(*number);
  }
  return numbers;
}

Vec3 ParseColorOption(const std::string& text, const std::string& where)
{
  const std::vector<std::string> items = Split(text);
  if (items.size() != 3)
  {
    return ParseColor(text, where);
  }
  const std::vector<double> numbers = ParseNumbers(text, where);
  for (const double number : numbers)
  {
    if (number < 0)
    {
      FailUsage("{} is '{}': the numbers of a colour must not be negative", where, text);
    }
  }
  return { numbers[0], numbers[1], numbers[2] };
}
}
