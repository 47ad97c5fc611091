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
#include <utility>
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
    double Budget = 0.0; ///< ms; 0: none
    bool Exempt = false; ///< the picture must not depend on times
    bool Still = false;  ///< the program knows that this is a still picture
    bool Changed = true; ///< the picture differs from the previous one by more than noise
    bool SceneChanged =
      false; ///< a prop appeared, disappeared or changed its shape, so that costs may jump
    double Pixels = 0.0; ///< of the picture
    double ClockTime = 0.0; ///< ms of a steady clock
  };

  using Techniques = std::vector<vtkSmartPointer<vtkGITechnique>>;

  /// Put settings in place for the next frame. number: of the frame, for Measure(). Returns whether they differ from those
  /// of the previous frame, so that averages over still frames must begin again.
  bool Begin(const Techniques& techniques, const Situation& situation, long long number);
  /// Put the user's settings back.
  void End();
  /// Tell that the cost of a frame is not typical.
  void Ignore(long long number);
  /// Tell what a frame cost.
  void Measure(const TimedFrame& frame);

  /// For processes that draw one picture together, before a frame that moves: what this one knows of costs, as numbers. A
  /// process that did not draw the last frame knows that it cost nothing.
  std::vector<double> Offer(const Techniques& techniques, const Situation& situation);
  /// The maximum of each number over all processes, from which all take the same decision. Begin() only puts it in place.
  void Accept(const Techniques& techniques, const std::vector<double>& most);

  State CurrentState() const { return this->Current; }
  /// Whether settings were lower than the user's own in the last frame.
  bool HasLowered() const { return !this->InForce.empty(); }
  /// One sentence if not even the lowest levels fit the budget, else "". It stays the same while that lasts.
  const std::string& Problem() const { return this->Sentence; }
  /// State, knobs and levels with their predicted costs and errors, as JSON.
  nlohmann::ordered_json Describe() const;

private:
  /// What is known of a frame's cost. In processes that share a budget, the highest value applies to all.
  enum class Progress
  {
    Measured,
    Pending,
    Ignored ///< not timed, or not typical
  };

  /// A frame whose cost the governor waits for.
  struct PendingFrame
  {
    long long Number;               ///< NotDrawn: in this process
    std::vector<std::string> Knobs; ///< their techniques
    FrameCost Cost;
    Progress Known = Progress::Pending;
    bool Shared = false; ///< no process may pass it on alone
  };
  static constexpr long long NotDrawn = -2;

  /// Which techniques took part in the last frame, 1 or 0 for each.
  static std::vector<double> TookPart(const Techniques& techniques);
  void FindKnobs(const Techniques& techniques, const std::vector<double>& tookPart);
  /// Choose the state and the levels of the next frame. number: see Begin().
  void Decide(const Techniques& techniques, const std::vector<double>& tookPart,
    const Situation& situation, long long number);
  /// Pass costs on to the governor, in order.
  void PassOn();
  /// A number that tells whether processes that share a budget have chosen the same levels.
  static double FingerprintOf(const std::vector<int>& levels);
  std::vector<std::pair<std::string, std::size_t>> NamesAndLevels() const;
  /// Whether the governor has chosen levels of these knobs before, and so knows what they cost.
  bool KnowsKnobs() const
  {
    return this->Chooser.Frame() > 0 && this->Known == this->NamesAndLevels();
  }
  State NextState(const Situation& situation);
  void WatchFloor();

  Governor Chooser;
  std::vector<TechniqueKnob> Knobs;
  std::vector<Knob> Declared; ///< Knobs, as the governor sees them
  std::vector<std::pair<std::string, std::size_t>>
    Known;                 ///< NamesAndLevels() of the governor's last choice
  std::vector<int> Levels; ///< in force
  std::vector<std::function<void()>> PutBack;
  std::vector<std::string> InForce; ///< what is lower than the user's own settings
  std::vector<bool> WasEnabled;     ///< by technique, when the knobs were last found
  std::deque<PendingFrame> Pending;
  State Current = State::Off;
  bool GoesOn =
    false; ///< a picture that must not depend on times has begun, and nothing has changed since
  bool IsDecided = false;    ///< by Accept(), for the next frame
  bool SceneChanged = false; ///< in frames since the last Offer()
  double SharedLevels = 0.0; ///< fingerprint of the last levels that Accept() chose
  double Budget = 0.0;
  double LastChange = 0.0; ///< ms of the clock
  int Refined = 0;         ///< number of frames since the scene came to rest
  std::string Sentence;
};
}
