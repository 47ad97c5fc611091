#version 430 core
// Irradiance from baked probes at points of surfaces, divided by pi, for a viewpoint right in front of each point.
// Variants: those of rays/passage.glsl and probes/field.glsl.
#include "shared/gathering.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "lib/spherical_harmonics.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "probes/field.glsl"
#include "sh_probes/light.glsl"

layout(local_size_x = GI_GATHER_GROUP) in;

uniform int pointCount;
uniform float offset; // distance of rays' origins from the surface

void main()
{
  int group = int(gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x);
  int index = group * GI_GATHER_GROUP + int(gl_LocalInvocationID.x);
  if (index >= pointCount)
  {
    return;
  }
  vec3 N = gatherPoints[index].Normal.xyz;
  vec3 P = gatherPoints[index].Position.xyz;
  Ray ray = Ray(P + offset * N, 0.0, N, RAY_FAR);
  RaySurfacePoint at;
  float first;
  uint state = giHash(uint(index));
  traceThrough(ray, at, first, state);
  vec3 light = fieldIrradiance(P, N, N, N, 0.5 * first);
  for (int k = 0; k < 3; ++k)
  {
    gatherResults[3 * index + k] = light[k];
  }
}
