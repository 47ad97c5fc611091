// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays that pass culled faces, clipped parts and, with a probability of one minus the opacity, translucent surfaces.
// Needs rays/surface.glsl, lib/sampling.glsl. Variants: GI_RAY_PARTLY (some surfaces let rays
// pass), GI_RAY_OPAQUE (rays pass all surfaces that are not opaque), and those of rays/surface.glsl.
const int RAY_PASSES = 64; // maximum number of surfaces that a ray passes
const float RAY_FAR = 1e30;

bool rayPasses(RaySurfacePoint at, int flags, inout uint state)
{
  bool culled = (flags & (at.front ? GI_SURFACE_CULL_FRONT : GI_SURFACE_CULL_BACK)) != 0;
#ifdef GI_RAY_CLIPPED
  culled = culled || rayClipped(raySurfaces[at.surface], at.position);
#endif
#ifdef GI_RAY_OPAQUE
  return culled || at.color.a < 1.0;
#else
  return culled || (at.color.a < 1.0 && giRandom(state) >= at.color.a);
#endif
}

// Traces a ray to the first surface that it does not pass. Moves ray.origin along the ray. first: distance to the first
// surface of any kind.
RayHit traceThrough(inout Ray ray, out RaySurfacePoint at, out float first, inout uint state)
{
  RayHit hit = traceClosest(ray);
  first = hit.instance >= 0 ? hit.t : RAY_FAR;
  if (hit.instance >= 0)
  {
    at = raySurfaceAt(ray, hit);
  }
#ifdef GI_RAY_PARTLY
  for (int i = 0; i < RAY_PASSES && hit.instance >= 0; ++i)
  {
    int flags = raySurfaces[at.surface].Where.z;
    if ((flags & GI_SURFACE_PARTLY) == 0 || !rayPasses(at, flags, state))
    {
      break;
    }
    ray.tMax -= hit.t;
    ray.origin = rayLeave(at, ray.direction);
    hit = traceClosest(ray);
    if (hit.instance >= 0)
    {
      at = raySurfaceAt(ray, hit);
    }
  }
#endif
  return hit;
}

// distance: to a surface that blocks the ray, in units of its direction's length.
bool blocked(Ray ray, out float distance, inout uint state)
{
#ifdef GI_RAY_PARTLY
  RaySurfacePoint at;
  float first;
  Ray left = ray;
  bool hit = traceThrough(left, at, first, state).instance >= 0;
  distance = hit ? dot(at.position - ray.origin, ray.direction) / dot(ray.direction, ray.direction) : ray.tMax;
  return hit;
#else
  RayHit hit = rayTrace(ray, true);
  distance = hit.t;
  return hit.instance >= 0;
#endif
}

bool blocked(Ray ray, inout uint state)
{
  float distance;
  return blocked(ray, distance, state);
}
