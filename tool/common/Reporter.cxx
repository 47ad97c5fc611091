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
}
