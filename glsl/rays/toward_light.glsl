// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow rays. Needs shared/light.h, lib/lights.glsl, rays/passage.glsl.

// Vector from a position to a light, and in w the multiple of it that must be unoccluded: 1 for a positional light,
// RAY_FAR for a directional one. Headlights shine from the eye.
vec4 rayTowardLight(LightData light, vec3 position, vec3 eye)
{
  bool head = light.Kind.z != 0;
  vec3 source = head ? eye : light.Position.xyz;
  return head || light.Kind.x == GI_LIGHT_POSITIONAL ? vec4(source - position, 1.0)
                                                     : vec4(-light.Direction.xyz, RAY_FAR);
}

// Whether light reaches a surface unoccluded. toward: result of rayTowardLight().
bool rayReaches(vec4 toward, RaySurfacePoint at, inout uint state)
{
  bool closed;
  vec3 origin = rayArrive(at, normalize(toward.xyz), closed);
  // The ray starts off the surface but still ends at the light.
  vec3 path = toward.w <= 1.0 ? toward.xyz + (at.position - origin) : toward.xyz;
  return !closed && !blocked(Ray(origin, 0.0, path, toward.w), state);
}
