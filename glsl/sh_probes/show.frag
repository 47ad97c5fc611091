#version 430 core
// Balls at the probes, white and lit by what each of them holds, over the picture.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/spherical_harmonics.glsl"
#include "probes/field.glsl"
#include "probes/spheres.glsl"
#include "sh_probes/light.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D before;

uniform mat3 viewToScene;
uniform vec3 eye; // relative to the scene's origin
uniform float radius;

layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = texelFetch(before, pixel, 0);
  vec3 near = giViewPosition(gl_FragCoord.xy, 0.0);
  vec3 path = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r) - near;
  vec3 N;
  int probe =
    fieldSphere(eye + viewToScene * near, viewToScene * normalize(path), length(path), radius, N);
  if (probe >= 0)
  {
    color.rgb = probeIrradiance(probe, N);
  }
}
