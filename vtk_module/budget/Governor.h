// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Picks a level of each knob so that moving frames stay within a budget with as little error as possible (Funkhouser and
 * Séquin 1993, Adaptive Display Algorithm for Interactive Frame Rates): costs are predicted from measured frames, so that a
 * larger window is answered before its first frame. As in the dynamic resolution of Unreal Engine, it goes down at once and up
 * with hesitation, so that levels do not flicker.
 *
 * Nothing here reads a clock or draws random numbers: governors that get the same numbers take the same decisions, on all ranks.
 */
#pragma once

#include "budget/CostModel.h"
#include "budget/LevelChoice.h"

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace penumbra
{
/// Measured times of one frame.
struct FrameCost
{
  long long Frame; ///< as Governor::Frame() returned after Choose
  double Total;    ///< ms of the whole frame
  /// ms of the passes of each knob's technique, in the order of the knobs
  std::vector<double> ByKnob;
};

class Governor
{
public:
  struct Situation
  {
    double Budget;     ///< ms; not positive or not a number: nothing fits
    double Pixels;     ///< of the picture; not positive or not a number: as before
    bool SceneChanged; ///< props came or went, or data was replaced: costs may jump
  };

  /// Levels for the next frame, one per knob. Knobs whose technique or number of levels is new start at their lowest level.
  const std::vector<int>& Choose(const std::vector<Knob>& knobs, const Situation& now);
  /// Number of the frame of the last Choose; the first is 1.
  long long Frame() const { return this->Number; }
  /// Tell what a frame cost: in order, up to 15 frames late, or never. Costs that are negative or not finite are ignored.
  void Measure(const FrameCost& cost);

  /// ms of a frame with the current levels.
  double PredictedTotal() const { return this->PredictedTotal(this->Levels); }
  /// ms of a frame with other levels.
  double PredictedTotal(const std::vector<int>& levels) const
  {
    return this->Model.Total(levels, this->Pixels);
  }
  /// ms of a frame with all knobs at their lowest levels.
  double Floor() const;
  /// ms of what no level changes.
  double Rest() const { return this->Model.Rest(this->Pixels); }
  /// ms of a knob at a level, for the current number of pixels.
  double Predicted(int knob, int level) const;
  /// ms that predicted frames are kept within, so that frames keep within a time: less a margin for the usual fluctuation, 5 to
  /// 22 % of it.
  double TargetFor(double milliseconds) const;
  double Target() const { return this->TargetFor(this->Budget); }
  /// The best levels for another time than the budget. The next choice does not depend on them.
  std::vector<int> LevelsFor(double milliseconds) const;
  /// Whether frames are too slow even at the lowest levels, as shown by at least 30 frames.
  bool FloorExceedsBudget() const { return this->FloorIsHigh; }
  /// Number of frames so far whose levels differ from those of the frame before.
  long long ChangeCount() const { return this->Changes; }

private:
  static constexpr long long Never = -1000000; ///< a frame long ago
  static constexpr std::size_t MostTotals = 120;
  /// After a start or a change of the scene, levels go up faster.
  static constexpr int SettleFrames = 56;
  /// After a change of the scene, one slow frame is enough to go down.
  static constexpr int JumpFrames = 10;
  /// Share of the budget that a step down aims at: room for drift before the next one.
  static constexpr double DownShare = 0.85;
  /// Times the prediction: slower frames are outliers rather than usual fluctuation.
  static constexpr double SpikeShare = 1.5;

  /// Levels and prediction of a past frame.
  struct PastFrame
  {
    long long Frame = 0;
    std::vector<int> Levels;
    double Pixels = 1.0;
    double Predicted = 0.0; ///< ms
    bool IsSteady = false;  ///< prediction and cost can be compared
  };

  /// Levels from some level on that did not fit, and are not tried again for a while.
  struct Bar
  {
    int Level = 0;
    long long Until = 0;
    int Length = 0; ///< frames; 0: there was none yet
  };

  /// The level that a knob had before its last change.
  struct LastLevel
  {
    int Level = 0;
    long long Frame = Never; ///< of the change
  };

  void Adopt(const std::vector<Knob>& knobs);
  void Note(const Situation& now);
  /// Whether lower levels would save no time.
  bool IsLowest(const std::vector<int>& levels) const;
  /// Whether a frame is less than this number of frames ago.
  bool IsWithin(long long frame, int frames) const;
  bool IsSettling() const;
  double MedianTotal() const; ///< ms, of the last five frames or fewer
  /// While settling: whether the levels prove too expensive by what was learned since.
  bool IsMistaken() const;
  bool IsOftenSlow() const; ///< whether many frames are slow, though less than half
  /// Ratio of measured to predicted time, at least 1, if levels must go down; 0 otherwise.
  double OverrunNow() const;
  /// After a start: measure the next level of each knob for a few frames, so that later steps know what they cost.
  void Probe();
  /// The levels that were chosen.
  std::vector<int> WithoutProbe() const;
  void GoDown(double overrun);
  void GoUp();
  /// Choose afresh, which may exchange levels between knobs, if that removes at least a share of the error.
  void Refresh(const std::vector<LevelValues>& values, double leastShare);
  /// Keep levels that were changed lately from returning.
  void KeepRecent(std::vector<LevelValues>& values) const;
  double Error(const std::vector<int>& levels) const;
  /// Whether the last frames would have met the budget with this cost (ms) added.
  bool IsSupported(double added) const;
  /// caution: factor on the added cost of levels that were never measured.
  std::vector<LevelValues> Values(double caution) const;
  void Set(const std::vector<int>& levels);
  void WatchFloor();

  CostModel Model;
  std::vector<Knob> Knobs;
  std::vector<int> Levels;
  std::vector<Bar> Bars;       ///< one per knob
  std::vector<LastLevel> Left; ///< one per knob
  std::array<PastFrame, 16> PastFrames;
  std::deque<double> Totals;      ///< ms of the frames since Since, at most MostTotals
  std::deque<double> Predictions; ///< ms, made after each of them for the next frame
  std::deque<double> Residuals;   ///< relative, of cost over prediction, at most 128
  double Budget = 0.0;
  double Pixels = 1.0;
  bool PixelsGrew = false; ///< in this frame
  bool IsStarted = false;
  bool IsProbing = false;
  int ProbedKnob = -1; ///< whose level is one up; -1: none yet
  bool FloorIsHigh = false;
  int FloorEvidence = 0;
  long long Number = 0;
  long long Changes = 0;
  // Numbers of frames; Never if there was none.
  long long Accepted = 0; ///< measurements of earlier frames belong to other knobs
  long long LastMeasured = 0;
  long long Since = 0;          ///< since when levels, pixels and scene are the same
  long long LastChange = Never; ///< of levels
  long long LastDown = Never;
  long long LastUp = Never;
  int LastUpKnob = 0;
  long long LastJump = Never;  ///< the scene changed after some quiet, or the picture grew
  long long LastScene = Never; ///< the scene changed
  long long SettleFrom = Never;
};
}
