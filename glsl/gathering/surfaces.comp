#version 430 core
// Samples points with uniform density over all surfaces: the intersections with lines of uniform density in space
// (Crofton's formula, see Santalo 1976, Integral Geometry and Geometric Probability). Each invocation follows one line
// and keeps a random one of its intersections. Variants: those of rays/passage.glsl.
#include "shared/gathering.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"

layout(local_size_x = GI_GATHER_GROUP) in;

const int MAX_SURFACES = 64; // maximum number of intersections along a line

uniform int pointCount;
uniform vec3 middle;  // centre of the scene
uniform float radius; // of its bounding sphere

void main()
{
  int group = int(gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x);
  int index = group * GI_GATHER_GROUP + int(gl_LocalInvocationID.x);
  if (index >= pointCount)
  {
    return;
  }
  vec2 u = giSample2D(uint(index), 1u);
  float z = 2.0 * u.x - 1.0;
  vec3 direction =
    vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(6.28318530717959 * u.y), sin(6.28318530717959 * u.y)), z);
  vec2 across = radius * giSampleDisc(giSample2D(uint(index), 2u));
  vec3 start = middle + giBasis(direction) * vec3(across, -radius);
  Ray ray = Ray(start, 0.0, direction, 2.0 * radius);
  uint state = giHash(uint(index));
  vec3 place = vec3(0.0);
  vec3 normal = vec3(0.0);
  int met = 0;
  while (met < MAX_SURFACES)
  {
    RaySurfacePoint at;
    float first;
    if (traceThrough(ray, at, first, state).instance < 0)
    {
      break;
    }
    ++met;
    if (giRandom(state) * float(met) < 1.0)
    {
      place = at.position;
      normal = at.geometric;
    }
    ray.origin = rayLeave(at, direction);
    ray.tMax = max(2.0 * radius - dot(ray.origin - start, direction), 0.0);
  }
  for (int k = 0; k < 3; ++k)
  {
    gatherResults[GI_SURFACE_NUMBERS * index + k] = place[k];
    gatherResults[GI_SURFACE_NUMBERS * index + 3 + k] = normal[k];
  }
  gatherResults[GI_SURFACE_NUMBERS * index + 6] = float(met);
}
