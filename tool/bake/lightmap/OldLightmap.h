// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The old form of lightmaps: OpenEXR with a picture of the light and parts that hold tables.
#ifndef penumbra_tool_lightmap_OldLightmap_h
#define penumbra_tool_lightmap_OldLightmap_h

#include "bake/lightmap/LightmapFile.h"

namespace penumbra::lightmap
{
/// Whether a file is OpenEXR, of whatever content.
bool IsOpenExr(const std::string& path);

/// Throws a Failure with the reason.
Lightmap ReadOldLightmap(const std::string& path);
}

#endif
