// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow rays. Needs shared/light.h, lib/lights.glsl, lib/light_points.glsl, rays/passage.glsl.

// Vector from a position to a light, and in w the multiple of it that must be unoccluded: 1 for a positional light,
// RAY_FAR for a directional one. Headlights shine from the eye.
vec4 rayTowardLight(LightData light, vec3 position, vec3 eye)
{
  bool head = light.Kind.z != 0;
  vec3 source = head ? eye : light.Position.xyz;
  return head || light.Kind.x == GI_LIGHT_POSITIONAL ? vec4(source - position, 1.0)
                                                     : vec4(-light.Direction.xyz, RAY_FAR);
}

// Light from one point of a light.
struct RayArrival
{
  vec4 toward; // as from rayTowardLight()
  vec3 L;      // unit vector to the point
  float share; // factor of the light's colour
};

// u: which point of a light that has a shape of its own; others have one only.
RayArrival rayArrival(LightData light, vec3 position, vec3 eye, vec2 u)
{
  GiIncident incident = giIncident(light, position);
  vec4 toward = rayTowardLight(light, position, eye);
  if (!giHasShape(light))
  {
    return RayArrival(toward, -incident.Travel, incident.Attenuation);
  }
  vec4 point = giLightPoint(light, position, u);
  return RayArrival(vec4(point.xyz, toward.w), normalize(point.xyz), incident.Attenuation * point.w);
}

// The same for a random point. The state of unshaped lights' random numbers stays.
RayArrival rayArrival(LightData light, vec3 position, vec3 eye, inout uint state)
{
  vec2 u = vec2(0.0);
  if (giHasShape(light))
  {
    u = vec2(giRandom(state), giRandom(state));
  }
  return rayArrival(light, position, eye, u);
}

// Whether light reaches a surface unoccluded. toward: result of rayTowardLight(). distance: of an occluder from the
// surface, as a multiple of toward.xyz.
bool rayReaches(vec4 toward, RaySurfacePoint at, out float distance, inout uint state)
{
  bool closed;
  vec3 origin = rayArrive(at, normalize(toward.xyz), closed);
  // The ray starts off the surface but still ends at the light.
  vec3 path = toward.w <= 1.0 ? toward.xyz + (at.position - origin) : toward.xyz;
  bool open = !blocked(Ray(origin, 0.0, path, toward.w), distance, state);
  distance = closed ? 0.0 : distance;
  return open && !closed;
}

bool rayReaches(vec4 toward, RaySurfacePoint at, inout uint state)
{
  float distance;
  return rayReaches(toward, at, distance, state);
}
