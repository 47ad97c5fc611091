// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Lightmaps as they were written before version 0.1.0: in OpenEXR.
#ifndef penumbra_tool_lightmap_OldLightmap_h
#define penumbra_tool_lightmap_OldLightmap_h

#include "bake/lightmap/LightmapFile.h"

namespace penumbra::lightmap
{
/// Whether a file is OpenEXR, of whatever content.
bool IsOpenExr(const std::string& path);

/// Throws a Failure that says what is wrong with the file.
Lightmap ReadOldLightmap(const std::string& path);
}

#endif
