// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Still frames that are averaged: each is drawn with another shift of a part of a pixel.
 */
#pragma once

namespace penumbra
{
class FrameBuilder;

/// Shift this frame, and give what VTK draws next the depth of the first one since the scene changed.
/// index: of the frame among those that are averaged; the first is not shifted. Call once a frame.
void ShiftStillFrame(FrameBuilder& frame, int index);
}
