// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/FrameBudget.h"

#include "vtkGITechnique.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace penumbra
{
namespace
{
// A hand on the mouse pauses for shorter than this while it turns the scene.
constexpr double RestMilliseconds = 150.0;
// A window that answers within this time seems to answer at once (Card, Robertson and Mackinlay 1991, The Information
// Visualizer).
constexpr double ResponsiveMilliseconds = 100.0;
constexpr int RefiningFrames = 8;

// ms that a frame which refines may take.
double RefiningTime(const FrameBudget::Situation& situation)
{
  return std::max(situation.Budget, ResponsiveMilliseconds);
}

const char* NameOf(FrameBudget::State state)
{
  constexpr const char* Names[] = { "off", "moving", "refining", "settled" };
  return Names[static_cast<int>(state)];
}
}

FrameBudget::State FrameBudget::NextState(const Situation& situation)
{
  this->GoesOn = situation.Exempt || (this->GoesOn && !situation.Changed);
  if (!(situation.Budget > 0.0) || situation.Exempt)
  {
    return State::Off;
  }
  if (situation.Still || this->GoesOn)
  {
    return State::Settled;
  }
  if (situation.Changed)
  {
    this->LastChange = situation.ClockTime;
    this->Refined = 0;
    return State::Moving;
  }
  const bool atRest = situation.ClockTime - this->LastChange > RestMilliseconds;
  // A settled picture stays settled until something changes.
  if (!atRest || this->Current == State::Settled)
  {
    return atRest ? State::Settled : State::Moving;
  }
  if (!this->KnowsKnobs())
  {
    // The budget, or a technique, was switched on at rest: nothing is known of costs.
    return State::Settled;
  }
  std::vector<int> own;
  for (const TechniqueKnob& knob : this->Knobs)
  {
    own.push_back(knob.NumberOfLevels() - 1);
  }
  const bool isCheap =
    this->Chooser.PredictedTotal(own) <= this->Chooser.TargetFor(RefiningTime(situation));
  return isCheap || ++this->Refined > RefiningFrames ? State::Settled : State::Refining;
}

std::vector<std::pair<std::string, std::size_t>> FrameBudget::NamesAndLevels() const
{
  std::vector<std::pair<std::string, std::size_t>> names;
  for (const Knob& knob : this->Declared)
  {
    names.emplace_back(knob.Technique, knob.Levels.size());
  }
  return names;
}

std::vector<double> FrameBudget::TookPart(const Techniques& techniques)
{
  std::vector<double> tookPart;
  for (vtkGITechnique* technique : techniques)
  {
    tookPart.push_back(technique->GetTookPart() ? 1.0 : 0.0);
  }
  return tookPart;
}

void FrameBudget::FindKnobs(const Techniques& techniques, const std::vector<double>& tookPart)
{
  this->Knobs.clear();
  this->Declared.clear();
  // Others may have taken a technique's place. Before the first frame nothing is known of that.
  const bool isKnown =
    std::any_of(tookPart.begin(), tookPart.end(), [](double part) { return part > 0.0; });
  for (std::size_t i = 0; i < techniques.size(); ++i)
  {
    // A technique that was just switched on cannot have taken part.
    const bool isNew = i >= this->WasEnabled.size() || !this->WasEnabled[i];
    if (!techniques[i]->GetEnabled() || (isKnown && !isNew && tookPart[i] <= 0.0))
    {
      continue;
    }
    TechniqueKnob knob(techniques[i]);
    if (knob.NumberOfLevels() > 1)
    {
      this->Declared.push_back(knob.ToKnob());
      this->Knobs.push_back(std::move(knob));
    }
  }
  this->WasEnabled.clear();
  for (vtkGITechnique* technique : techniques)
  {
    this->WasEnabled.push_back(technique->GetEnabled());
  }
}

void FrameBudget::Decide(const Techniques& techniques, const std::vector<double>& tookPart,
  const Situation& situation, long long number)
{
  this->Budget = situation.Budget;
  if (situation.Budget > 0.0)
  {
    this->FindKnobs(techniques, tookPart);
  }
  this->Current = this->NextState(situation);
  if (this->Current == State::Moving)
  {
    this->Levels = this->Chooser.Choose(
      this->Declared, { situation.Budget, situation.Pixels, situation.SceneChanged });
    this->Known = this->NamesAndLevels();
    PendingFrame pending{ number, {}, { this->Chooser.Frame(), 0.0, {} } };
    for (const TechniqueKnob& knob : this->Knobs)
    {
      pending.Knobs.emplace_back(knob.Technique()->GetName());
    }
    this->Pending.push_back(std::move(pending));
    this->WatchFloor();
  }
  else if (this->Current == State::Refining)
  {
    this->Levels = this->Chooser.LevelsFor(RefiningTime(situation));
  }
  else
  {
    this->Levels.clear(); // the user's own settings
  }
}

bool FrameBudget::Begin(const Techniques& techniques, const Situation& situation, long long number)
{
  this->End();
  std::vector<std::string> before = std::move(this->InForce);
  this->InForce.clear();
  this->SceneChanged = this->SceneChanged || situation.SceneChanged;
  if (this->IsDecided && situation.Budget > 0.0 && !situation.Exempt && !situation.Still)
  {
    this->Pending.back().Number = number;
  }
  else
  {
    this->Decide(techniques, TookPart(techniques), situation, number);
    if (this->Current == State::Moving)
    {
      // The other processes are not there to tell what these frames cost.
      this->Pending.erase(std::remove_if(this->Pending.begin(), this->Pending.end(),
                            [](const PendingFrame& pending) { return pending.Shared; }),
        this->Pending.end());
    }
  }
  this->IsDecided = false;
  for (std::size_t k = 0; k < this->Levels.size(); ++k)
  {
    const TechniqueKnob& knob = this->Knobs[k];
    if (this->Levels[k] < knob.NumberOfLevels() - 1)
    {
      this->InForce.push_back(
        std::string(knob.Technique()->GetName()) + " " + knob.Name(this->Levels[k]));
      this->PutBack.push_back(knob.Apply(this->Levels[k]));
    }
  }
  return this->InForce != before;
}

void FrameBudget::End()
{
  for (const auto& putBack : this->PutBack)
  {
    putBack();
  }
  this->PutBack.clear();
}

void FrameBudget::Ignore(long long number)
{
  for (PendingFrame& pending : this->Pending)
  {
    pending.Known = pending.Number == number ? Progress::Ignored : pending.Known;
  }
  this->PassOn();
}

void FrameBudget::Measure(const TimedFrame& frame)
{
  for (PendingFrame& pending : this->Pending)
  {
    if (pending.Number == NotDrawn || pending.Known != Progress::Pending)
    {
      continue;
    }
    if (pending.Number < frame.Number)
    {
      pending.Known = Progress::Ignored; // not timed
    }
    else if (pending.Number == frame.Number)
    {
      pending.Known = Progress::Measured;
      pending.Cost.Total = frame.Milliseconds;
      for (const std::string& technique : pending.Knobs)
      {
        double sum = 0.0;
        for (const TimedSpan& span : frame.Spans)
        {
          sum += span.Technique == technique ? span.Milliseconds : 0.0;
        }
        pending.Cost.ByKnob.push_back(sum);
      }
    }
  }
  this->PassOn();
}

void FrameBudget::PassOn()
{
  while (!this->Pending.empty() && !this->Pending.front().Shared &&
    this->Pending.front().Known != Progress::Pending)
  {
    if (this->Pending.front().Known == Progress::Measured)
    {
      this->Chooser.Measure(this->Pending.front().Cost);
    }
    this->Pending.pop_front();
  }
}

void FrameBudget::WatchFloor()
{
  if (!this->Chooser.FloorExceedsBudget())
  {
    this->Sentence.clear();
    return;
  }
  if (!this->Sentence.empty())
  {
    return;
  }
  const double others = this->Chooser.Rest();
  std::size_t dearest = 0;
  for (std::size_t k = 1; k < this->Knobs.size(); ++k)
  {
    const auto cost = [this](std::size_t knob) {
      return this->Chooser.Predicted(static_cast<int>(knob), 0);
    };
    dearest = cost(k) > cost(dearest) ? k : dearest;
  }
  const bool geometry = others > this->Budget || this->Knobs.empty();
  char text[320];
  std::snprintf(text, sizeof(text), "%s %.1f of the budget's %.1f ms: %s%s",
    geometry ? "What no level governs, such as geometry, lights and filters, takes"
             : "The lowest levels still take",
    geometry ? others : this->Chooser.Floor(), this->Budget,
    geometry ? "fewer triangles, a smaller window or fewer techniques would help"
             : "what would help most is to switch off ",
    geometry ? "" : this->Knobs[dearest].Technique()->GetName());
  this->Sentence = text;
}

nlohmann::ordered_json FrameBudget::Describe() const
{
  using nlohmann::ordered_json;
  ordered_json knobs = ordered_json::array();
  for (std::size_t k = 0; this->KnowsKnobs() && k < this->Knobs.size(); ++k)
  {
    const TechniqueKnob& knob = this->Knobs[k];
    const double most = this->Chooser.Predicted(static_cast<int>(k), knob.NumberOfLevels() - 1);
    if (most <= 0.0 && this->Chooser.PredictedTotal() > 0.0)
    {
      continue; // it has nothing to do in this scene
    }
    ordered_json levels = ordered_json::array();
    for (int level = 0; level < knob.NumberOfLevels(); ++level)
    {
      levels.push_back({ { "name", knob.Name(level) },
        { "milliseconds", this->Chooser.Predicted(static_cast<int>(k), level) },
        { "error", this->Declared[k].Levels[level].Error } });
    }
    knobs.push_back({ { "technique", knob.Technique()->GetName() },
      { "approach", knob.Technique()->GetApproach() },
      { "level", this->Levels.empty() ? knob.NumberOfLevels() - 1 : this->Levels[k] },
      { "levels", levels } });
  }
  return { { "milliseconds", this->Budget }, { "state", NameOf(this->Current) },
    { "floor", this->Chooser.Floor() }, { "predicted", this->Chooser.PredictedTotal() },
    { "knobs", knobs } };
}
}
