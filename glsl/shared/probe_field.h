// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes of a field of probes. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#endif

#define GI_FIELD_GRIDS 6     // maximum number of nested grids
#define GI_FIELD_DISTANCE 16 // width of a distance map in texels, without its border
#define GI_FIELD_LIGHT 8     // width of a live probe's irradiance map in texels, without its border
#define GI_FIELD_HARMONICS 7 // texels of a baked probe: nine harmonics of three colours
