#version 430 core
// Traces one ray per invocation, from a buffer of queries to a buffer of answers. Variants: GI_RAY_ANY (answer only
// whether there is a hit: Hit.x is 0 or -1), and those of rays/trace.glsl.
#include "rays/trace.glsl"
#include "shared/ray_query.h"

layout(local_size_x = GI_RAY_QUERY_GROUP) in;

uniform int rayCount;

void main()
{
  uint index = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * uint(GI_RAY_QUERY_GROUP) +
    gl_GlobalInvocationID.x;
  if (index >= uint(rayCount))
  {
    return;
  }
  RayQuery query = rayQueries[index];
  Ray ray = Ray(query.Origin.xyz, query.Origin.w, query.Direction.xyz, query.Direction.w);
  RayAnswer answer;
  answer.Unused = ivec2(0);
#ifdef GI_RAY_ANY
  answer.Hit = ivec2(traceAny(ray) ? 0 : -1, -1);
  answer.Barycentrics = vec2(0.0);
  answer.Distance = ray.tMax;
  answer.User = -1;
#else
  RayHit hit = traceClosest(ray);
  answer.Hit = ivec2(-1);
  answer.Barycentrics = hit.barycentrics;
  answer.Distance = hit.t;
  answer.User = -1;
  if (hit.instance >= 0)
  {
    ivec2 instance = rayHitInstance(hit);
    answer.Hit = ivec2(instance.x, rayHitPrimitive(hit));
    answer.User = instance.y;
  }
#endif
  rayAnswers[index] = answer;
}
