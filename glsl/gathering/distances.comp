#version 430 core
// How far surfaces are from points, by direction: an invocation for each texel of a point's octahedral map. Rays
// are spread about the texel's direction by the 64th power of the cosine, as DDGI blends them. Variants: those of
// rays/passage.glsl.
#include "shared/gathering.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"

layout(local_size_x = GI_GATHER_GROUP) in;

uniform int pointCount;
uniform int firstPoint; // of all that are asked for
uniform int texels;     // across a map
uniform int samples;    // rays of a texel
uniform float farthest; // distances beyond it count as this

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
