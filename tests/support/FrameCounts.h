// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Counts of a frame's passes, bytes and samples, which do not depend on the load of the machine.
 */
#pragma once

#include "Stage.h"

#include <set>
#include <string>

namespace penumbra_test
{
struct FrameCounts
{
  std::multiset<std::string> Passes; ///< their names
  long Bytes = 0;                    ///< of the pool's textures
  long Samples = 0;                  ///< samples of all draws that passed the depth test
};

/// Count a frame of a static scene whose pass collects statistics. Frames are drawn first until the pool has freed the
/// textures that this frame does not use.
FrameCounts CountFrame(Stage& stage, vtkGIPass* pass);
}
