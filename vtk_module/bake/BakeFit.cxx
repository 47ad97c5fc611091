// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/BakeFit.h"

#include "technique/FrameBuilder.h"

namespace penumbra
{
void BakeFit::Check(FrameBuilder& frame, const BakedScene& baked, const std::string& complaint)
{
  const View& view = frame.GetView();
  this->Difference = this->Watch.Difference(
    baked, frame.GetRenderer(), view.Changes.Props || view.Changes.Appearance, view.FrameNumber);
  if (!this->Difference.empty())
  {
    frame.AddNote(complaint + ": " + this->Difference + " since the bake");
  }
}
}
