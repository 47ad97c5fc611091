// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cost of a frame at each level of each knob, learned from measured frames. The cost of a knob is
 *   scale * shape(level), times the number of pixels if the knob works per pixel.
 * The scale stands for the scene and the machine, the shape for the ratio of the levels. Everything that no knob governs is the
 * rest.
 */
#pragma once

#include <string>
#include <vector>

namespace penumbra
{
/// One choice of a technique, of which the governor picks a level for each moving frame.
struct KnobLevel
{
  double Work; ///< relative amount of work, in any unit; ascending. 0: the technique does not run
  /// Measured error (relMSE) that this level adds over the user's own settings; descending, 0 at the top.
  double Error;
};

struct Knob
{
  std::string Technique;
  bool PerPixel; ///< whether its cost grows with the number of pixels
  /// From the cheapest to the user's own settings. Without any, the level is 0 and costs nothing.
  std::vector<KnobLevel> Levels;
};

/// A running mean that rises fast, as a missed budget is seen at once, and falls slowly. It takes the median of the last three
/// values, so that one spike changes nothing.
class CostEstimate
{
public:
  bool IsKnown() const { return this->Known; }
  double Get() const { return this->Mean; }
  void Set(double mean);
  /// The median of the last values; of two, the lower one.
  double Median(double value);
  /// Move towards a median; isFast: downwards as fast as upwards. The first three values count in full.
  void Follow(double median, bool isFast);
  /// The next values have nothing to do with those before, such as after a change of levels. The mean stays.
  void ForgetValues() { this->Count = 0; }
  int ValueCount() const { return this->Count; }
  /// Whether the mean rests on fewer than three values.
  bool IsYoung() const { return this->Young; }

private:
  double Values[3] = {};
  int Count = 0; ///< values since they were forgotten
  double Mean = 0.0;
  bool Known = false;
  bool Young = true;
};

class CostModel
{
public:
  /// Measured cost of one frame.
  struct Sample
  {
    const std::vector<int>& Levels; ///< in force in that frame
    double Pixels;
    double Total;                      ///< ms of the whole frame
    const std::vector<double>& ByKnob; ///< ms of each knob's passes
    bool IsNew;  ///< the scene has just changed: its costs say nothing of the ratio of levels
    bool IsSlow; ///< believe a higher cost at once, without a median
  };

  /// Keeps what is known of knobs with the same technique and number of levels. Returns for each knob the index that it
  /// had before, or -1 for a new one.
  std::vector<int> SetKnobs(const std::vector<Knob>& knobs);
  void Learn(const Sample& sample);

  /// Cost in ms of a technique that was never seen at work, at its lowest level that does work.
  void SetGuess(double guess) { this->Guess = guess; }
  /// ms
  double Predict(int knob, int level, double pixels) const;
  /// ms that no knob governs. It is taken to grow with the number of pixels, but not to shrink with it.
  double Rest(double pixels) const;
  /// ms
  double Total(const std::vector<int>& levels, double pixels) const;
  /// Whether the cost of a level was measured, or else is only inferred from others.
  bool IsSeen(int knob, int level) const;

private:
  struct KnobCost
  {
    std::string Technique;
    bool PerPixel;
    std::vector<double> Prior;   ///< shape that follows from the work; 0 for levels without work
    std::vector<double> Factors; ///< shape over prior; 0 while unknown
    CostEstimate Scale;
    CostEstimate Idle;    ///< ms of levels without work
    int Level = -1;       ///< of the last sample
    int Frames = 0;       ///< samples since the level changed
    bool IsFirst = false; ///< the level was never seen before

    void SetWork(const Knob& knob);
    double Factor(int level) const;
    void Learn(int level, double cost, bool isNew, bool isSlow);
    void LearnFactor(int level, double factor, int values);
  };

  std::vector<KnobCost> Costs;
  CostEstimate RestCost;
  double RestPixels = 1.0; ///< to which RestCost belongs
  double Guess = 0.0;
};
}
