// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "technique/TechniqueKnob.h"

#include "technique/Parameters.h"
#include "vtkGITechnique.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace penumbra
{
namespace
{
// More work fills the processors better and shares more of what it reads, so that costs grow more slowly. Measured with DDGI's
// rays per frame (exponents of 0.79 to 0.91) and the resolution of ray-traced light (0.82).
constexpr double CostExponent = 0.85;
// Steps whose gain cannot be told from the noise of its measurement still count a little, so that time to spare goes to the
// user's own settings.
constexpr double LeastStep = 2e-5;
}

TechniqueKnob::TechniqueKnob(vtkGITechnique* technique)
  : Owner(technique)
{
  std::vector<double> own;
  const BudgetInfo* table = technique->BudgetTable();
  if (table)
  {
    for (const BudgetFactor& factor : table->Work)
    {
      own.push_back(technique->FindParameter(factor.Parameter)->Get(technique));
    }
    const double ownWork = this->Work(own);
    for (const BudgetLevel& declared : table->Levels)
    {
      Level level{ declared.Values, 0.0, declared.Error };
      for (std::size_t i = 0; i < own.size(); ++i)
      {
        const BudgetFactor& factor = table->Work[i];
        const bool cheaper = this->Amount(factor, level.Values[i]) < this->Amount(factor, own[i]);
        level.Values[i] = cheaper ? level.Values[i] : own[i];
      }
      level.Work = this->Work(level.Values);
      const double last = this->Levels.empty() ? 0.0 : this->Levels.back().Work;
      if (level.Work > last && level.Work < ownWork)
      {
        this->Levels.push_back(level);
      }
    }
    // The error of the user's own settings does not count against the levels.
    const double missing = this->ErrorOf(ownWork);
    for (Level& level : this->Levels)
    {
      level.Error = std::max(level.Error - missing, 0.0);
    }
  }
  this->Levels.push_back({ own, this->Work(own), 0.0 });
}

double TechniqueKnob::Amount(const BudgetFactor& factor, double value) const
{
  if (!factor.Factors.empty())
  {
    return factor.Factors[static_cast<std::size_t>(value)];
  }
  double number = value;
  if (value == 0.0 && !factor.Zero.empty())
  {
    number = 1.0;
    for (const char* name : factor.Zero)
    {
      number *= this->Owner->FindParameter(name)->Get(this->Owner);
    }
  }
  return std::pow(number, factor.Exponent);
}

double TechniqueKnob::Work(const std::vector<double>& values) const
{
  double work = 1.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    work *= this->Amount(this->Owner->BudgetTable()->Work[i], values[i]);
  }
  return work;
}

double TechniqueKnob::ErrorOf(double work) const
{
  const std::vector<BudgetLevel>& levels = this->Owner->BudgetTable()->Levels;
  double below = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    const double here = this->Work(levels[i].Values);
    if (work <= here)
    {
      const double share = i == 0 ? 1.0 : std::log(work / below) / std::log(here / below);
      return i == 0 ? levels[i].Error
                    : levels[i - 1].Error + share * (levels[i].Error - levels[i - 1].Error);
    }
    below = here;
  }
  return levels.back().Error;
}

Knob TechniqueKnob::ToKnob() const
{
  const BudgetInfo* table = this->Owner->BudgetTable();
  Knob knob{ this->Owner->GetName(), table && table->PerPixel, {} };
  double steps = static_cast<double>(this->Levels.size());
  for (const Level& level : this->Levels)
  {
    steps -= 1.0;
    knob.Levels.push_back({ std::pow(level.Work, CostExponent), level.Error + LeastStep * steps });
  }
  return knob;
}

std::string TechniqueKnob::Name(int level) const
{
  std::ostringstream name;
  const std::vector<double>& own = this->Levels.back().Values;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const double value = this->Levels[level].Values[i];
    const char* parameter = this->Owner->BudgetTable()->Work[i].Parameter;
    const ParameterInfo* info = this->Owner->FindParameter(parameter);
    if (value == own[i])
    {
      continue;
    }
    name << (name.tellp() > 0 ? " " : "") << parameter << "=";
    info->Values.empty() ? name << value : name << info->Values[static_cast<std::size_t>(value)];
  }
  return name.tellp() > 0 ? name.str() : "own settings";
}

std::function<void()> TechniqueKnob::Apply(int level) const
{
  vtkGITechnique* technique = this->Owner;
  const auto put = [technique](const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      technique->FindParameter(technique->BudgetTable()->Work[i].Parameter)
        ->Put(technique, values[i]);
    }
  };
  const std::vector<double>& lowered = this->Levels[level].Values;
  put(lowered);
  // Keep values that the user has set in the meantime, in an observer.
  return [technique, lowered, own = this->Levels.back().Values] {
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      const ParameterInfo* info =
        technique->FindParameter(technique->BudgetTable()->Work[i].Parameter);
      if (info->Get(technique) == lowered[i])
      {
        info->Put(technique, own[i]);
      }
    }
  };
}
}
