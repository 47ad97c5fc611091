// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays from a surface toward light. Needs shared/light.h, lib/lights.glsl, rays/passage.glsl.

// From a place to where a light shines from, and in w the part of that path that must be free: all of it, or RAY_FAR
// times a direction. Headlights shine from the eye.
vec4 rayTowardLight(LightData light, vec3 position, vec3 eye)
{
  bool head = light.Kind.z != 0;
  vec3 source = head ? eye : light.Position.xyz;
  return head || light.Kind.x == GI_LIGHT_POSITIONAL ? vec4(source - position, 1.0)
                                                     : vec4(-light.Direction.xyz, RAY_FAR);
}

// Whether nothing is in the way to a surface. toward: as above.
bool rayReaches(vec4 toward, RaySurfacePoint at, inout uint state)
{
  bool closed;
  vec3 origin = rayArrive(at, normalize(toward.xyz), closed);
  // To the point that the light comes from, from where it arrives.
  vec3 path = toward.w <= 1.0 ? toward.xyz + (at.position - origin) : toward.xyz;
  return !closed && !blocked(Ray(origin, 0.0, path, toward.w), state);
}
