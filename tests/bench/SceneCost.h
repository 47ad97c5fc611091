// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cost of baked and live light in frames of small scenes, and of the first frame of many glyphs. Frames with and without
 * the light alternate.
 */
#pragma once

namespace bench
{
/// A lightmap over direct light with shadow maps, at 1280 x 720, by processor time. True where it keeps its limits.
bool ReportLightmapCost(int turns);

/// Indirect light in a volume that every ray goes through to its end, by processor time. True where it keeps its limits.
bool ReportVolumeCost(int turns);

/// Frames of 302,500 glyphs, by the clock: the rasterizer's first, the path tracer's first, and two after it.
bool ReportGlyphCost();
}
