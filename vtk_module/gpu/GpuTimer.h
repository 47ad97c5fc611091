// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Times of the parts of a frame. A GPU writes a timestamp after each part; they are read frames later, when it is done, so
 * that nothing waits. Software OpenGL, and contexts without timer queries, are timed by the clock, part by part.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <array>
#include <chrono>
#include <string>
#include <vector>

namespace penumbra
{
/// A part of a frame: a pass of the frame graph, or what is done before or after the graph.
struct TimedSpan
{
  std::string Name;
  std::string Technique; ///< that added the pass; "" for none
  double Milliseconds = 0.0;
};

struct TimedFrame
{
  long long Number = 0;
  std::vector<TimedSpan> Spans; ///< in order
  double Milliseconds = 0.0;    ///< of the frame: of the GPU or of the CPU, whichever is longer
};

class GpuTimer
{
public:
  enum class Method
  {
    Automatic, ///< timestamps, or the clock where they are missing or tell nothing
    Timestamps,
    Clock
  };
  /// For the current context, in which all other methods must be called.
  explicit GpuTimer(Method method = Method::Automatic);

  /// Begin a frame. A frame that was begun and not ended is forgotten. If the GPU is more than four frames behind, this
  /// one is not timed.
  void BeginFrame(long long number);
  /// Tell that a part is done, which began at the last call or with the frame.
  void Mark(const std::string& name, const std::string& technique = {});
  void EndFrame();

  /// Frames whose times are known by now, the oldest first. Each is returned once.
  std::vector<TimedFrame> Collect() { return this->Read(false); }
  /// The same, but wait for those that are not known yet.
  std::vector<TimedFrame> Wait() { return this->Read(true); }

private:
  using Clock = std::chrono::steady_clock;
  struct Slot
  {
    TimedFrame Frame;
    std::vector<QueryHandle>
      Queries;              ///< timestamps, one more than there are spans; kept for later frames
    double Processor = 0.0; ///< milliseconds of the CPU
    bool Waiting = false;   ///< complete, and not read yet
  };
  std::vector<TimedFrame> Read(bool wait);
  bool ReadSlot(Slot& slot, bool wait) const;
  void Stamp();

  bool UsesClock;
  std::array<Slot, 4> Ring;
  std::size_t Next = 0;        ///< slot of the next frame, and the oldest
  Slot* Current = nullptr;     ///< of the frame that is being timed
  std::size_t Stamps = 0;      ///< of the current frame
  Clock::time_point Beginning; ///< of the frame
  Clock::time_point LastMark;
};
}
