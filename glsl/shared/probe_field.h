// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes of a field of probes. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#endif

#define GI_FIELD_GRIDS 6     // at most, one within the other
#define GI_FIELD_DISTANCE 16 // texels across a map of distances, without its border
#define GI_FIELD_LIGHT 8     // texels across a live probe's map of irradiance, without its border
#define GI_FIELD_HARMONICS 7 // texels of a baked probe's light: nine harmonics of three colours
