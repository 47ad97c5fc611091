// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Constants of the denoiser that passes and shaders share. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#endif

#define GI_DENOISING_TILE 16 // width and height of a tile in pixels
