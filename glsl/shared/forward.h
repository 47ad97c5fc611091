// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Constants of the light on translucent surfaces and volumes, which VTK draws itself. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#endif

// Number of lights that cast shadows there. Further lights are unshadowed.
#define GI_FORWARD_LIGHTS 64
