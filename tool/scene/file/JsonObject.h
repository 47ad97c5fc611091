// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Strict reading of JSON objects: all keys must be known, and all values of the right type.
#pragma once

#include "scene/model/SceneModel.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace penumbra::tool
{
/// Inclusive bounds of a number.
struct Bounds
{
  double Low = std::numeric_limits<double>::lowest();
  double High = std::numeric_limits<double>::max();
};
constexpr Bounds NotNegative = { 0, std::numeric_limits<double>::max() };
constexpr Bounds Positive = { std::numeric_limits<double>::min(),
  std::numeric_limits<double>::max() };
constexpr Bounds UnitInterval = { 0, 1 };

/// Each Read() makes a key known, and leaves its target unchanged if the key is absent. Finish() throws a Failure for an
/// unknown key, and suggests the nearest one.
class JsonObject
{
public:
  /// where: the object's name in messages, such as "light 2".
  JsonObject(const nlohmann::json& value, std::string where);

  const std::string& Where() const { return this->Name; }
  /// The value or nullptr. Makes the key known.
  const nlohmann::json* Find(const std::string& key);

  void Read(const std::string& key, double& target, Bounds bounds = {});
  void Read(const std::string& key, int& target, Bounds bounds = {});
  void Read(const std::string& key, bool& target);
  void Read(const std::string& key, std::string& target);
  void Read(const std::string& key, Vec3& target);
  void Read(const std::string& key, std::vector<double>& target);
  void Read(const std::string& key, std::vector<std::string>& target);
  /// A colour: three numbers, "#rrggbb" or a name.
  void ReadColor(const std::string& key, Vec3& target);
  void ReadColor(const std::string& key, std::optional<Vec3>& target);

  template <typename T, typename... Rest>
  void Read(const std::string& key, std::optional<T>& target, Rest... rest)
  {
    if (this->Find(key))
    {
      T value{};
      this->Read(key, value, rest...);
      target = value;
    }
  }

  template <typename T>
  void ReadChoice(
    const std::string& key, T& target, const std::vector<std::pair<std::string, T>>& choices)
  {
    std::string name;
    this->Read(key, name);
    std::vector<std::string> names;
    for (const auto& choice : choices)
    {
      names.push_back(choice.first);
      if (choice.first == name)
      {
        target = choice.second;
        return;
      }
    }
    if (!name.empty())
    {
      this->FailChoice(key, name, names);
    }
  }

  /// Calls a function for each element of an array.
  void ForEach(const std::string& key,
    const std::function<void(const nlohmann::json& value, const std::string& where)>& read);

  /// Throws a Failure for the first unknown key.
  void Finish() const;

private:
  /// The value, or nullptr; throws a Failure if it is of another type.
  const nlohmann::json* Find(
    const std::string& key, bool (nlohmann::json::*isType)() const noexcept, const char* type);
  [[noreturn]] void FailType(const std::string& key, const std::string& type) const;
  [[noreturn]] void FailChoice(
    const std::string& key, const std::string& name, const std::vector<std::string>& names) const;
  double Number(const nlohmann::json& value, const std::string& key) const;

  const nlohmann::json& Value;
  std::string Name;
  std::vector<std::string> Known;
};

/// A colour from "#rrggbb" or one of a few names. Throws a Failure for other text.
Vec3 ParseColor(const std::string& text, const std::string& where);
}
