// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Still frames that are averaged: each is drawn with another shift of a part of a pixel.
 */
#pragma once

namespace penumbra
{
class FrameBuilder;

/// Shift this frame, if the scene stood still before it, and give what VTK draws next the depth of
/// the frame that was not shifted. After `maximum` frames the shifts begin anew. Call once a frame.
void ShiftStillFrame(FrameBuilder& frame, int maximum);
}
