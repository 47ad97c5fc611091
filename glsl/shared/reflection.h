// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Outcomes of reflection rays in screen space, and the shape of the depth pyramid that they march
// through. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#endif

// Outcome at a pixel.
#define GI_REFLECTION_NONE 0    // nothing reflects here: background, matte, or drawn by VTK
#define GI_REFLECTION_HIT 1     // the ray hit a visible surface
#define GI_REFLECTION_LEFT 2    // the ray left the screen
#define GI_REFLECTION_HIDDEN 3  // the ray went behind an occluder and hit nothing visible afterwards
#define GI_REFLECTION_STEPS 4   // the ray used up its steps
#define GI_REFLECTION_ROUGH 5   // not marched: the surface is too rough
#define GI_REFLECTION_FACING 6  // the ray came back toward the eye, which sees no surface that faces it
#define GI_REFLECTION_EMPTY 7   // the ray hit nothing
#define GI_REFLECTION_BACK 8    // the ray hit the side of a surface that the eye does not see
#define GI_REFLECTION_WEAK 9    // not marched: the surface reflects too little
#define GI_REFLECTION_HORIZON 10 // the direction points into the surface, where nothing is reflected
#define GI_REFLECTION_RAY 11    // missed on the screen, hit by a ray through the scene
#define GI_REFLECTION_ENDS 12

// Number of levels above the depth buffer itself. Texels of the last one are 64 pixels wide.
#define GI_PYRAMID_LEVELS 6
#define GI_PYRAMID_GROUP 16 // threads along each side of a group, four pixels each
