// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frame budget of a view. While anything moves, it lowers the techniques' settings so that a frame takes no longer than
 * the budget; when nothing changes for a while, the user's own settings come back, so that a still picture does not
 * depend on the speed of the machine.
 */
#pragma once

#include "gpu/GpuTimer.h"
#include "technique/TechniqueKnob.h"

#include "vtkSmartPointer.h"

#include <nlohmann/json_fwd.hpp>

#include <deque>
#include <string>
#include <vector>

class vtkGITechnique;

namespace penumbra
{
class FrameBudget
{
public:
  enum class State
  {
    Off,      ///< no budget, or a picture that must not depend on times
    Moving,   ///< levels fit the budget
    Refining, ///< at rest for a moment: levels fit the time in which a window still responds
    Settled   ///< the user's own settings
  };

  struct Situation
  {
    double Budget = 0.0;       ///< ms; 0: none
    bool Exempt = false;       ///< the picture must not depend on times
    bool Still = false;        ///< the program knows that this is a still picture
    bool Changed = true;       ///< the picture differs from the previous one by more than noise
    bool SceneChanged = false; ///< a prop appeared, disappeared or changed its shape, so that costs may jump
    double Pixels = 0.0;       ///< of the picture
    double Now = 0.0;          ///< ms of a steady clock
  };

  /// Put settings in place for the next frame. number: of the frame, for Measure(). Returns whether they differ from those
  /// of the previous frame, so that averages over still frames must begin again.
  bool Begin(const std::vector<vtkSmartPointer<vtkGITechnique>>& techniques,
    const Situation& situation, long long number);
  /// Put the user's settings back.
  void End();
  /// Tell that the cost of a frame is not typical.
  void Ignore(long long number);
  /// Tell what a frame cost.
  void Measure(const TimedFrame& frame);

  State CurrentState() const { return this->Current; }
  /// One sentence if not even the lowest levels fit the budget, else "". It stays the same while that lasts.
  const std::string& Problem() const { return this->Sentence; }
  /// State, knobs and levels with their predicted costs and errors, as JSON.
  nlohmann::ordered_json Describe() const;

private:
  /// A frame whose cost the governor waits for.
  struct Asked
  {
    long long Number;
    long long GovernorFrame;
    std::vector<std::string> Knobs; ///< their techniques
  };

  void FindKnobs(const std::vector<vtkSmartPointer<vtkGITechnique>>& techniques);
  State NextState(const Situation& situation);
  std::vector<int> ChooseFor(double milliseconds) const;
  double CostAt(const std::vector<int>& levels) const;
  double CostOfOthers() const;
  void WatchFloor();

  Governor Chooser;
  std::vector<TechniqueKnob> Knobs;
  std::vector<Knob> Declared; ///< Knobs, as the governor sees them
  std::vector<int> Levels;    ///< in force
  std::vector<std::function<void()>> PutBack;
  std::vector<std::string> InForce; ///< what is lower than the user's own settings
  std::deque<Asked> Waiting;
  State Current = State::Off;
  double Budget = 0.0;
  double LastChange = 0.0; ///< ms of the clock
  int Refined = 0;         ///< number of frames since the scene came to rest
  std::string Sentence;
};
}
