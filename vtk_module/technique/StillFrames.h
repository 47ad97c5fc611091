// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Jitter of still frames that are averaged.
 */
#pragma once

#include <glm/glm.hpp>

namespace penumbra
{
class FrameBuilder;

/// Jitter of an averaged frame, from -0.5 to 0.5 pixels. index: number of averaged frames before it. The first frame is not
/// jittered.
/// A sequence that is evenly distributed for any number of frames (Roberts 2018, The Unreasonable Effectiveness of
/// Quasirandom Sequences), in both directions from the pixel's centre: 0, 1, -1, 2, -2 and so on. Each frame with an even
/// index mirrors the one before it, so that their mean is not shifted.
glm::dvec2 StillFrameShift(int index);

/// Jitter this frame by a fraction of a pixel, and restore the depth of the first frame since the scene changed, which is not
/// jittered, for what VTK draws next. Call once per frame.
void ShiftStillFrame(FrameBuilder& frame, const glm::dvec2& pixels);
}
