// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instrument/FrameChartData.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace penumbra
{
namespace
{
using nlohmann::json;

/// Values of the wrong type count as missing: a chart of the other values is better than none.
double Number(const json& object, const char* key)
{
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? Drawable(found->get<double>()) : 0.0;
}

/// One line of text. Longer names than this fit nowhere in a chart.
std::string Text(const json& object, const char* key)
{
  constexpr std::size_t most = 60;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string())
  {
    return "";
  }
  std::string text = found->get<std::string>();
  for (char& character : text)
  {
    // VTK takes text between two dollar signs for a formula.
    const bool plain = static_cast<unsigned char>(character) >= 32 && character != 127;
    character = plain && character != '$' ? character : ' ';
  }
  if (text.size() > most)
  {
    std::size_t end = most - 3;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
    {
      --end; // not within a character of several bytes
    }
    text = text.substr(0, end) + "...";
  }
  return text;
}

Approach ReadApproach(const json& object)
{
  const std::string name = Text(object, "approach");
  for (int i = 0; i < ApproachCount; ++i)
  {
    if (name == ApproachName(static_cast<Approach>(i)))
    {
      return static_cast<Approach>(i);
    }
  }
  return Approach::Rest;
}

/// The objects of a list; none if the key is missing.
std::vector<json> Objects(const json& object, const char* key)
{
  std::vector<json> found;
  const auto list = object.find(key);
  if (list != object.end() && list->is_array())
  {
    std::copy_if(list->begin(), list->end(), std::back_inserter(found),
      [](const json& item) { return item.is_object(); });
  }
  return found;
}

ChartKnob ReadKnob(const json& object)
{
  ChartKnob knob;
  knob.Technique = Text(object, "technique");
  knob.Payment = ReadApproach(object);
  for (const json& item : Objects(object, "levels"))
  {
    knob.Levels.push_back(
      { Text(item, "name"), Number(item, "milliseconds"), Number(item, "error") });
  }
  const auto level = object.find("level");
  if (level != object.end() && level->is_number_integer())
  {
    const auto index = level->get<long long>();
    knob.Level = index >= 0 && index < static_cast<long long>(knob.Levels.size())
      ? static_cast<int>(index)
      : -1;
  }
  return knob;
}

std::array<double, ApproachCount> ReadMoment(const json& object)
{
  std::array<double, ApproachCount> moment{};
  double sum = 0.0;
  for (int i = 0; i < ApproachCount; ++i)
  {
    moment[i] = Number(object, ApproachName(static_cast<Approach>(i)));
    sum += moment[i];
  }
  moment[static_cast<int>(Approach::Rest)] += std::max(0.0, Number(object, "frame") - sum);
  return moment;
}

void ReadBudget(const json& budget, FrameChartData& data)
{
  data.HasBudget = true;
  data.Budget = Number(budget, "milliseconds");
  data.Floor = Number(budget, "floor");
  data.State = Text(budget, "state");
  data.Frame = std::max(data.Frame, Number(budget, "frame"));
  for (const json& item : Objects(budget, "knobs"))
  {
    data.Knobs.push_back(ReadKnob(item));
  }
  for (const json& item : Objects(budget, "history"))
  {
    data.History.push_back(ReadMoment(item));
  }
}
}

const char* ApproachName(Approach approach)
{
  constexpr std::array<const char*, ApproachCount> names = { "precompute", "approximate",
    "amortise", "rest" };
  return names[static_cast<int>(approach)];
}

double Drawable(double number)
{
  constexpr double most = 1e12;
  return std::isfinite(number) ? std::clamp(number, 0.0, most) : 0.0;
}

bool ReadFrameChart(const char* text, FrameChartData& data, std::string& error)
{
  try
  {
    const json root = json::parse(text ? text : "");
    const auto passes = root.is_object() ? root.find("passes") : root.end();
    if (!root.is_object() || passes == root.end() || !passes->is_array())
    {
      error = "The statistics of a frame have no list \"passes\": give the text of "
              "vtkGIPass::GetStatistics().";
      return false;
    }
    FrameChartData read;
    read.Frame = Number(root, "milliseconds");
    for (const json& item : Objects(root, "passes"))
    {
      read.Passes.push_back({ Text(item, "name"), Text(item, "technique"), ReadApproach(item),
        Number(item, "milliseconds") });
    }
    const auto budget = root.find("budget");
    if (budget != root.end() && budget->is_object())
    {
      ReadBudget(*budget, read);
    }
    data = std::move(read);
    error.clear();
    return true;
  }
  catch (const json::exception& exception)
  {
    error =
      std::string("The statistics of a frame cannot be read as JSON: ") + exception.what() + ".";
    return false;
  }
}
}
