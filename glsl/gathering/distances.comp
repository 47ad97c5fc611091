#version 430 core
// Distances of surfaces from points, by direction: one invocation per texel of a point's octahedral map. Rays
// are distributed around the texel's direction by the 64th power of the cosine, as DDGI weights them. Variants: those
// of rays/passage.glsl.
#include "shared/gathering.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"

layout(local_size_x = GI_GATHER_GROUP) in;

uniform int pointCount;
uniform int firstPoint; // index of the first point among all requested ones
uniform int texels;     // width of a map
uniform int samples;    // rays per texel
uniform float farthest; // upper bound of distances

void main()
{
  int group = int(gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x);
  int index = group * GI_GATHER_GROUP + int(gl_LocalInvocationID.x);
  int point = index / (texels * texels);
  if (point >= pointCount)
  {
    return;
  }
  int texel = index % (texels * texels);
  mat3 basis = giBasis(giDecodeOctahedral(
    (vec2(texel % texels, texel / texels) + 0.5) / float(texels)));
  uint seed = giHash(uint(index + firstPoint * texels * texels));
  uint state = giHash(seed);
  vec3 sums = vec3(0.0);
  for (int i = 0; i < samples; ++i)
  {
    vec3 direction = basis * giSamplePower(giSample2D(uint(i), seed), 64.0);
    Ray ray = Ray(gatherPoints[point].Position.xyz, 0.0, direction, RAY_FAR);
    RaySurfacePoint at;
    float first;
    RayHit hit = traceThrough(ray, at, first, state);
    bool met = hit.instance >= 0;
    float distance =
      met ? min(length(at.position - gatherPoints[point].Position.xyz), farthest) : farthest;
    sums += vec3(distance, distance * distance, met && !at.front ? 1.0 : 0.0);
  }
  for (int k = 0; k < 3; ++k)
  {
    gatherResults[3 * index + k] = sums[k] / float(samples);
  }
}
