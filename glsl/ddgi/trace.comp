#version 430 core
// A ray of a probe: the radiance of the surface that it meets, lit by the lamps and by the probes, and how far
// that is. Variants: GI_RAY_SKY (the surroundings shine), and those of rays/passage.glsl.
#define GI_POSITIONAL 1
#include "shared/light.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/lights.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#ifdef GI_RAY_SKY
#define GI_RAY_SKY_CELLS 1
#include "rays/sky.glsl"
#endif
#include "ddgi/field.glsl"
#include "ddgi/directions.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

layout(rgba32f, binding = 0) uniform writeonly image2D found; // radiance, distance; a row for each probe

uniform vec3 eye; // relative to the scene's origin: headlights shine from there
uniform int rays;
uniform int update;
uniform int lightCount;
uniform int firstProbe;
uniform int lastProbe; // one past it
uniform bool lit;  // the probes hold light already

const float PI = 3.14159265;
const int MOST_LAMPS = 4; // of more, one is picked by chance

// What a lamp sends to a surface, divided by pi. VTK's lamps stand for an irradiance of pi times their colour
// where Phong materials look at them, and of their colour where PBR ones do.
vec3 arriving(LightData lamp, RaySurfacePoint at, bool pbr, inout uint state)
{
  GiIncident incident = giIncident(lamp, at.position);
  float facing = -dot(at.normal, incident.Travel);
  if (facing <= 0.0 || incident.Attenuation <= 0.0)
  {
    return vec3(0.0);
  }
  if (!rayReaches(rayTowardLight(lamp, at.position, eye), at, state))
  {
    return vec3(0.0);
  }
  return lamp.Color.rgb * (incident.Attenuation * facing * (pbr ? 1.0 / PI : 1.0));
}

vec3 lampLight(RaySurfacePoint at, bool pbr, inout uint state)
{
  vec3 sum = vec3(0.0);
  bool all = lightCount <= MOST_LAMPS;
  for (int i = 0; i < (all ? lightCount : 1); ++i)
  {
    int chosen = all ? i : min(int(giRandom(state) * float(lightCount)), lightCount - 1);
    sum += (all ? 1.0 : float(lightCount)) * arriving(lights[chosen], at, pbr, state);
  }
  return sum;
}

void main()
{
  int index = int(gl_GlobalInvocationID.x) + firstProbe * rays;
  int probe = index / rays;
  if (probe >= lastProbe)
  {
    return;
  }
  if (probeRests(probe, update, probeState(probe)))
  {
    return;
  }
  int number = index - probe * rays;
  vec3 direction = fieldTurn(probe, update) * fieldDirection(number);
  uint state = giHash(uint(index) ^ giHash(uint(update) * 0x9e3779b9u));
  Ray ray = Ray(fieldPosition(fieldGridWith(probe), probe), 0.0, direction, RAY_FAR);
  vec3 start = ray.origin;
  RaySurfacePoint at;
  float first;
  RayHit hit = traceThrough(ray, at, first, state);
  vec4 result = vec4(0.0, 0.0, 0.0, RAY_FAR);
  if (hit.instance >= 0)
  {
    int model = raySurfaces[at.surface].Where.z & GI_SURFACE_MODEL;
    result.rgb = at.emission;
    result.a = length(at.position - start);
    if (model != GI_SURFACE_UNLIT)
    {
      bool pbr = model == GI_SURFACE_PBR;
      // All that a surface reflects goes on evenly here.
      vec3 albedo = pbr ? at.occlusion * mix(at.color.rgb * (1.0 - at.specular.w) + at.specular.w, at.color.rgb, at.metallic)
                        : at.color.rgb;
      vec3 light = lampLight(at, pbr, state);
      if (lit)
      {
        light += fieldIrradiance(at.position, at.normal, at.normal, -direction, result.a);
      }
      result.rgb += min(albedo, vec3(1.0)) * light;
    }
  }
#ifdef GI_RAY_SKY
  else
  {
    result.rgb = raySkyMean(direction);
  }
#endif
  bool broken = any(isnan(result)) || any(isinf(result));
  imageStore(found, ivec2(number, probe), broken ? vec4(0.0, 0.0, 0.0, RAY_FAR) : result);
}
