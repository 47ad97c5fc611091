// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// How scene building tells what it does: notes, and steps with progress.
#pragma once

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkObject;

namespace penumbra::tool
{
/// Receives notes and progress; this base class ignores them, as tests and benchmarks want.
class Reporter
{
public:
  virtual ~Reporter() = default;
  /// One sentence about a choice made or data left out.
  virtual void Note(const std::string& /*sentence*/) {}
  /// After so many seconds of processor time the step may be stopped as hopeless; 0 sets no limit.
  virtual void BeginStep(const std::string& /*what*/, double /*longest*/) {}
  virtual void Advance(double /*fraction*/) {}
  virtual void EndStep() {}
};

/// A step as a scope: "reading 'head.vti'".
class Step
{
public:
  Step(Reporter& reporter, const std::string& what, double longest = 0)
    : Target(reporter)
  {
    this->Target.BeginStep(what, longest);
  }
  ~Step() { this->Target.EndStep(); }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  /// Forwards the algorithm's progress events to the reporter; ends with the algorithm.
  void Observe(vtkAlgorithm* algorithm);
  void Note(const std::string& sentence) { this->Target.Note(sentence); }
  void Advance(double fraction) { this->Target.Advance(fraction); }

private:
  Reporter& Target;
};

/// Tells of the progress of a VTK object for as long as this lives.
class ProgressWatch
{
public:
  ProgressWatch(vtkObject* watched, std::function<void(double)> advance);
  ~ProgressWatch();
  ProgressWatch(const ProgressWatch&) = delete;
  ProgressWatch& operator=(const ProgressWatch&) = delete;

private:
  vtkObject* Watched;
  std::function<void(double)> Advance;
  unsigned long Tag;
};
}
