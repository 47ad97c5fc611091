// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Notes and progress of building and baking.
#pragma once

#include <vtkCommand.h>
#include <vtkObject.h>

#include <functional>
#include <string>

namespace penumbra::tool
{
using Progress = std::function<void(double)>;

/// Receives notes and progress. This base class ignores them, for tests and benchmarks.
class Reporter
{
public:
  virtual ~Reporter() = default;
  /// One sentence about an automatic choice or about data left out.
  virtual void Note(const std::string& /*sentence*/) {}
  /// limit: seconds of processor time after which the step may be stopped; 0 for no limit.
  virtual void BeginStep(const std::string& /*what*/, double /*limit*/) {}
  virtual void Advance(double /*fraction*/) {}
  virtual void EndStep() {}

  static Reporter& None()
  {
    static Reporter none;
    return none;
  }
};

/// A step as a scope: "reading 'head.vti'".
class Step
{
public:
  Step(Reporter& reporter, const std::string& what, double limit = 0)
    : Target(reporter)
  {
    this->Target.BeginStep(what, limit);
  }
  ~Step() { this->Target.EndStep(); }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  void Note(const std::string& sentence) { this->Target.Note(sentence); }
  void Advance(double fraction) { this->Target.Advance(fraction); }
  Progress GetProgress()
  {
    return [this](double fraction) { this->Advance(fraction); };
  }
  /// Forwards the progress events of a VTK algorithm, which must not outlive the step.
  void Observe(vtkObject* algorithm)
  {
    algorithm->AddObserver(vtkCommand::ProgressEvent, this, &Step::Forward);
  }

private:
  void Forward(vtkObject*, unsigned long, void* fraction)
  {
    this->Advance(fraction ? *static_cast<double*>(fraction) : 0);
  }
  Reporter& Target;
};

/// Forwards the progress events of a VTK object for as long as this exists.
class ProgressObserver
{
public:
  ProgressObserver(vtkObject* observed, Progress advance)
    : Observed(observed)
    , Advance(std::move(advance))
    , Tag(observed->AddObserver(vtkCommand::ProgressEvent, this, &ProgressObserver::Forward))
  {
  }
  ~ProgressObserver() { this->Observed->RemoveObserver(this->Tag); }
  ProgressObserver(const ProgressObserver&) = delete;
  ProgressObserver& operator=(const ProgressObserver&) = delete;

private:
  void Forward(vtkObject*, unsigned long, void* fraction)
  {
    this->Advance(fraction ? *static_cast<double*>(fraction) : 0);
  }
  vtkObject* Observed;
  Progress Advance;
  unsigned long Tag;
};
}
