// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common/Reporter.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>

namespace penumbra::tool
{
void Step::Observe(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(&this->Target);
  forward->SetCallback([](vtkObject* caller, unsigned long, void* target, void*) {
    static_cast<Reporter*>(target)->Advance(static_cast<vtkAlgorithm*>(caller)->GetProgress());
  });
  algorithm->AddObserver(vtkCommand::ProgressEvent, forward);
}

ProgressWatch::ProgressWatch(vtkObject* watched, std::function<void(double)> advance)
  : Watched(watched)
  , Advance(std::move(advance))
{
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(this);
  forward->SetCallback([](vtkObject*, unsigned long, void* self, void* share) {
    static_cast<ProgressWatch*>(self)->Advance(*static_cast<double*>(share));
  });
  this->Tag = watched->AddObserver(vtkCommand::ProgressEvent, forward);
}

ProgressWatch::~ProgressWatch()
{
  this->Watched->RemoveObserver(this->Tag);
}
}
