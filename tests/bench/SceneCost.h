// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cost of baked and live light in frames of small scenes, and of the first frame of many glyphs. Frames with and
 * without the light alternate.
 */
#pragma once

namespace bench
{
/// Measure the cost of a lightmap over direct light with shadow maps, at 1280 x 720, in processor time. Returns whether
/// it keeps its limits.
bool ReportLightmapCost(int turns);

/// Measure the cost of indirect light in a volume that no ray leaves early, in processor time. Returns whether it keeps
/// its limits.
bool ReportVolumeCost(int turns);

/// Measure frames of 302,500 glyphs in seconds of real time: the rasterizer's first, and the path tracer's first three.
bool ReportGlyphCost();
}
