#version 430 core
// Joins the parts of the maps that neighbouring pixels have looked up. Variant: GI_STRIDE.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/alike.glsl"
layout(binding = 0) uniform usampler2D rawTexture;
#include "sky_light/raw.glsl"
#include "sky_light/window.glsl"

layout(location = 0) out uvec4 result;

void main()
{
  GiSkySum sum = giSkyWindow(ivec2(gl_FragCoord.xy));
  result = giPackSky(sum);
}
