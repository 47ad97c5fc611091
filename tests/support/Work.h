// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Counts of the work in a frame. They are the same on a busy machine as on an idle one.
 */
#pragma once

#include "Stage.h"

#include <set>
#include <string>

namespace penumbra_test
{
struct FrameWork
{
  std::multiset<std::string> Passes; ///< names
  long Bytes = 0;                    ///< of the pool's textures
  long Samples = 0;                  ///< that passed the depth test, of all draws
};

/// Of a frame of a scene at rest, whose pass collects statistics. Earlier frames are drawn first, until textures that
/// this one does not use are gone.
FrameWork WorkOfFrame(Stage& stage, vtkGIPass* pass);
}
