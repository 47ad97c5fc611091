// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// How a reflection ray in screen space ended, and the shape of the depth pyramid that it marches
// through. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#endif

// A pixel has one of these.
#define GI_REFLECTION_NONE 0    // nothing there that reflects: background, matte, drawn by VTK
#define GI_REFLECTION_HIT 1     // found on the screen
#define GI_REFLECTION_LEFT 2    // the ray left the screen
#define GI_REFLECTION_HIDDEN 3  // it went behind something, and met nothing visible afterwards
#define GI_REFLECTION_STEPS 4   // it took all its steps
#define GI_REFLECTION_ROUGH 5   // not marched: the surface is too rough
#define GI_REFLECTION_FACING 6  // it came back toward the eye, which sees no surface facing it
#define GI_REFLECTION_EMPTY 7   // it met nothing
#define GI_REFLECTION_BACK 8    // it met the side of a surface that the eye does not see
#define GI_REFLECTION_WEAK 9    // not marched: the surface reflects too little
#define GI_REFLECTION_HORIZON 10 // its direction leads into the surface: nothing is reflected there
#define GI_REFLECTION_RAY 11    // missing on the screen, found by a ray through the scene
#define GI_REFLECTION_ENDS 12

// Levels above the depth buffer itself; texels of the last are 64 pixels wide.
#define GI_PYRAMID_LEVELS 6
#define GI_PYRAMID_GROUP 16 // threads of a side, four pixels each
