// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/BakedScene.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace penumbra
{
namespace
{
constexpr const char* Header = "penumbra scene 1";
constexpr const char* KindNames[] = { "prop", "lamp", "surroundings" };
constexpr const char* ChangeTexts[][3] = { { "moved", "changed its shape", "changed its look" },
  { "moved", "changed its colour or strength", "changed its kind" },
  { "was turned", "changed its picture", "changed" } };
}

std::string BakedScene::ToText() const
{
  std::ostringstream text;
  text << Header << "\n" << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const Entry& entry : this->Entries)
  {
    text << KindNames[entry.Type];
    for (const auto& values : entry.Values)
    {
      text << " " << values.size();
      for (const double value : values)
      {
        text << " " << value;
      }
    }
    std::string name = entry.Name;
    std::replace(name.begin(), name.end(), '\n', ' ');
    text << " " << name << "\n";
  }
  return text.str();
}

BakedScene BakedScene::FromText(const std::string& text)
{
  const auto fail = [] {
    throw std::invalid_argument(
      "it does not tell which scene it was baked of: bake it again with this version");
  };
  BakedScene scene;
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != Header)
  {
    fail();
  }
  while (std::getline(lines, line))
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    const auto* found = std::find(std::begin(KindNames), std::end(KindNames), kind);
    Entry entry;
    entry.Type = static_cast<Kind>(found - std::begin(KindNames));
    for (auto& values : entry.Values)
    {
      std::size_t count = 0;
      words >> count;
      if (!words || count > line.size())
      {
        fail();
      }
      values.resize(count);
      for (double& value : values)
      {
        // Not by >>, which rejects numbers that are not finite.
        std::string number;
        words >> number;
        value = std::strtod(number.c_str(), nullptr);
      }
    }
    if (!words || found == std::end(KindNames))
    {
      fail();
    }
    std::getline(words >> std::ws, entry.Name);
    scene.Entries.push_back(entry);
  }
  return scene;
}

// Equal up to rounding, which may differ between compilers.
bool BakedScene::NearlyEqual(const std::vector<double>& a, const std::vector<double>& b)
{
  constexpr double tolerance = 1e-6;
  double largest = 0.0;
  for (const double value : a)
  {
    largest = std::max(largest, std::abs(value));
  }
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [largest](double x, double y) { return x == y || std::abs(x - y) <= tolerance * largest; });
}

int BakedScene::CountEqualTraits(const Entry& a, const Entry& b)
{
  int equalTraits = 0;
  for (int i = 0; i < Traits; ++i)
  {
    equalTraits += NearlyEqual(a.Values[i], b.Values[i]) ? 1 : 0;
  }
  return equalTraits;
}

void BakedScene::Compare(std::vector<const Entry*> baked, std::vector<const Entry*> current,
  std::vector<std::string>& differences)
{
  // Match the entries with the most equal traits first, so that identical ones are matched before any others.
  for (int equalTraits = Traits; equalTraits > 0; --equalTraits)
  {
    for (auto& entry : baked)
    {
      const auto match = std::find_if(current.begin(), current.end(), [&](const Entry* other) {
        return entry && other && CountEqualTraits(*entry, *other) == equalTraits;
      });
      if (match == current.end())
      {
        continue;
      }
      for (int i = 0; i < Traits && equalTraits < Traits; ++i)
      {
        if (!NearlyEqual(entry->Values[i], (*match)->Values[i]))
        {
          differences.push_back(entry->Name + " " + ChangeTexts[entry->Type][i]);
        }
      }
      entry = nullptr;
      *match = nullptr;
    }
  }
  for (const Entry* entry : baked)
  {
    if (entry)
    {
      differences.push_back(
        entry->Name + (entry->Type == LightSource ? " went out" : " is gone or hidden"));
    }
  }
  for (const Entry* entry : current)
  {
    if (entry && entry->Type != Prop)
    {
      differences.push_back(entry->Name + " came");
    }
  }
}

std::string BakedScene::DifferenceTo(const BakedScene& current) const
{
  std::vector<std::string> differences;
  for (int kind = 0; kind < Kinds; ++kind)
  {
    const auto select = [kind](const std::vector<Entry>& entries) {
      std::vector<const Entry*> selected;
      for (const Entry& entry : entries)
      {
        if (entry.Type == kind)
        {
          selected.push_back(&entry);
        }
      }
      return selected;
    };
    Compare(select(this->Entries), select(current.Entries), differences);
  }
  if (differences.empty())
  {
    return "";
  }
  const std::size_t more = differences.size() - 1;
  return differences.front() + (more > 0 ? " and " + std::to_string(more) + " more changes" : "");
}

std::string BakedSceneWatch::Difference(
  const BakedScene& baked, vtkRenderer* renderer, bool changed, int frameNumber)
{
  if (changed || (this->Frame != frameNumber && this->Frame + 1 != frameNumber))
  {
    this->Props.clear();
    this->Solid = BakedScene::AddProps(renderer, this->Cache, {}, this->Props);
  }
  this->Frame = frameNumber;
  BakedScene current;
  current.Entries = this->Props;
  BakedScene::AddLights(renderer, current.Entries);
  BakedScene::AddEnvironment(renderer, this->Cache, current.Entries);
  return baked.DifferenceTo(current);
}
}
