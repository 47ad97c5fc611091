// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// What VTK draws itself, translucent surfaces and volumes. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#endif

// Lights that have shadows there; further ones shine without.
#define GI_FORWARD_LIGHTS 64
