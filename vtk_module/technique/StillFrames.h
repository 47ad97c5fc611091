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

/// By how many pixels a frame is shifted. index: as of ShiftStillFrame().
glm::dvec2 StillFrameJitter(int index);

/// Shift this frame by a fraction of a pixel, and restore the depth of the first frame since the scene changed for what
/// VTK draws next. index: of the frame among those that are averaged; the first is not shifted. Call once per frame.
void ShiftStillFrame(FrameBuilder& frame, int index);
}
