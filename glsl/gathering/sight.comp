#version 430 core
// Visibility between two points: 1 or 0. The second point is in GatherPoint::Normal. Variants: those of
// rays/passage.glsl.
#include "shared/gathering.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"

layout(local_size_x = GI_GATHER_GROUP) in;

uniform int pointCount;

void main()
{
  int group = int(gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x);
  int index = group * GI_GATHER_GROUP + int(gl_LocalInvocationID.x);
  if (index >= pointCount)
  {
    return;
  }
  vec3 from = gatherPoints[index].Position.xyz;
  vec3 to = gatherPoints[index].Normal.xyz;
  uint state = giHash(uint(index));
  gatherResults[index] = blocked(Ray(from, 0.0, to - from, 1.0), state) ? 0.0 : 1.0;
}
