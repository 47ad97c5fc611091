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
constexpr const char* Head = "penumbra scene 1";
constexpr const char* Words[] = { "prop", "lamp", "surroundings" };
constexpr const char* Changed[][3] = { { "moved", "changed its shape", "changed its look" },
  { "moved", "changed its colour or strength", "changed its kind" },
  { "was turned", "changed its picture", "changed" } };
}

std::string BakedScene::ToText() const
{
  std::ostringstream text;
  text << Head << "\n" << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const Thing& thing : this->Things)
  {
    text << Words[thing.What];
    for (const auto& values : thing.Values)
    {
      text << " " << values.size();
      for (const double value : values)
      {
        text << " " << value;
      }
    }
    std::string name = thing.Name;
    std::replace(name.begin(), name.end(), '\n', ' ');
    text << " " << name << "\n";
  }
  return text.str();
}

BakedScene BakedScene::FromText(const std::string& text)
{
  const auto refuse = [] {
    throw std::invalid_argument(
      "it does not tell which scene it was baked of: bake it again with this version");
  };
  BakedScene scene;
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != Head)
  {
    refuse();
  }
  while (std::getline(lines, line))
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    const auto* found = std::find(std::begin(Words), std::end(Words), kind);
    Thing thing;
    thing.What = static_cast<Kind>(found - std::begin(Words));
    for (auto& values : thing.Values)
    {
      std::size_t count = 0;
      words >> count;
      if (!words || count > line.size())
      {
        refuse();
      }
      values.resize(count);
      for (double& value : values)
      {
        // Not by >>, which refuses what is not finite.
        std::string number;
        words >> number;
        value = std::strtod(number.c_str(), nullptr);
      }
    }
    if (!words || found == std::end(Words))
    {
      refuse();
    }
    std::getline(words >> std::ws, thing.Name);
    scene.Things.push_back(thing);
  }
  return scene;
}

// The same but for rounding: another compiler may place things by the last digit elsewhere.
bool BakedScene::Alike(const std::vector<double>& a, const std::vector<double>& b)
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

int BakedScene::AlikeTraits(const Thing& a, const Thing& b)
{
  int alike = 0;
  for (int i = 0; i < Traits; ++i)
  {
    alike += Alike(a.Values[i], b.Values[i]) ? 1 : 0;
  }
  return alike;
}

void BakedScene::Compare(std::vector<const Thing*> baked, std::vector<const Thing*> now,
  std::vector<std::string>& differences)
{
  // Those that are most alike are taken for the same thing, first of all those that are the same.
  for (int alike = Traits; alike > 0; --alike)
  {
    for (auto& thing : baked)
    {
      const auto same = std::find_if(now.begin(), now.end(),
        [&](const Thing* other) { return thing && other && AlikeTraits(*thing, *other) == alike; });
      if (same == now.end())
      {
        continue;
      }
      for (int i = 0; i < Traits && alike < Traits; ++i)
      {
        if (!Alike(thing->Values[i], (*same)->Values[i]))
        {
          differences.push_back(thing->Name + " " + Changed[thing->What][i]);
        }
      }
      thing = nullptr;
      *same = nullptr;
    }
  }
  for (const Thing* thing : baked)
  {
    if (thing)
    {
      differences.push_back(
        thing->Name + (thing->What == Lamp ? " went out" : " is gone or hidden"));
    }
  }
  for (const Thing* thing : now)
  {
    if (thing && thing->What != Prop)
    {
      differences.push_back(thing->Name + " came");
    }
  }
}

std::string BakedScene::DifferenceTo(const BakedScene& now) const
{
  std::vector<std::string> differences;
  for (int kind = 0; kind < Kinds; ++kind)
  {
    const auto all = [kind](const std::vector<Thing>& things) {
      std::vector<const Thing*> some;
      for (const Thing& thing : things)
      {
        if (thing.What == kind)
        {
          some.push_back(&thing);
        }
      }
      return some;
    };
    Compare(all(this->Things), all(now.Things), differences);
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
  BakedScene now;
  now.Things = this->Props;
  BakedScene::AddLamps(renderer, now.Things);
  BakedScene::AddSurroundings(renderer, this->Cache, now.Things);
  return baked.DifferenceTo(now);
}
}
