// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Reads a JSON object strictly: every key must be known and every value of the right kind.
#pragma once

#include "scene/model/SceneModel.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace penumbra::tool
{
/// Bounds of a number, included.
struct Bounds
{
  double Low = std::numeric_limits<double>::lowest();
  double High = std::numeric_limits<double>::max();
};
constexpr Bounds NotNegative = { 0, std::numeric_limits<double>::max() };
constexpr Bounds Positive = { std::numeric_limits<double>::min(),
  std::numeric_limits<double>::max() };
constexpr Bounds UnitInterval = { 0, 1 };

/// Each Read() leaves its target alone where the key is absent, and makes the key known. Finish() then
/// throws a Failure for a key that is not, naming the nearest.
class JsonObject
{
public:
  /// where is how sentences name the object: "light 2".
  JsonObject(const nlohmann::json& value, std::string where);

  const std::string& Where() const { return this->Name; }
  /// The value, or nullptr; makes the key known.
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
    if (name.empty())
    {
      return;
    }
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
    this->FailChoice(key, name, names);
  }

  /// Calls read for each element of an array.
  void ForEach(const std::string& key,
    const std::function<void(const nlohmann::json& value, const std::string& where)>& read);

  /// Throws a Failure for the first unknown key.
  void Finish() const;

private:
  [[noreturn]] void FailKind(const std::string& key, const std::string& wanted) const;
  [[noreturn]] void FailChoice(
    const std::string& key, const std::string& name, const std::vector<std::string>& names) const;
  double Number(const nlohmann::json& value, const std::string& key) const;

  const nlohmann::json& Value;
  std::string Name;
  std::vector<std::string> Known;
};

/// Three numbers from 0, "#rrggbb", or the name of one of a few colours; throws a Failure otherwise.
Vec3 ParseColor(const std::string& text, const std::string& where);
}
