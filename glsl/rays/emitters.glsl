// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples points of the surfaces that emit light, by their power. Needs rays/surface.glsl, lib/sampling.glsl.
uniform int emitterCount;

// Converts the density of light sampling from per area to per solid angle. from: where the solid angle is measured;
// to, normal: the sampled point.
float emitterDensity(float perArea, vec3 from, vec3 to, vec3 normal)
{
  vec3 path = to - from;
  float square = dot(path, path);
  return perArea * square * sqrt(square) / max(abs(dot(normal, path)), 1e-20);
}

int pickEmitter(float u)
{
  int low = 0;
  int high = emitterCount - 1;
  while (low < high)
  {
    int middle = (low + high) / 2;
    bool before = u < rayEmitters[middle].A.w;
    high = before ? middle : high;
    low = before ? low : middle + 1;
  }
  return low;
}

// A sampled point of an emitter.
struct EmitterPoint
{
  vec3 path;      // from the receiver to the point
  vec3 emission;
  float density;  // per solid angle at the receiver
  float perArea;  // the same per area
};

EmitterPoint emitterPoint(vec2 u, vec3 from)
{
  int index = pickEmitter(u.x);
  float before = index > 0 ? rayEmitters[index - 1].A.w : 0.0;
  RayEmitter emitter = rayEmitters[index];
  float within = clamp((u.x - before) / max(emitter.A.w - before, 1e-20), 0.0, 1.0);
  vec2 weights = giSampleTriangle(vec2(within, u.y));
  vec3 edge1 = emitter.B.xyz - emitter.A.xyz;
  vec3 edge2 = emitter.C.xyz - emitter.A.xyz;
  vec3 across = cross(edge1, edge2);
  vec3 target = emitter.A.xyz + weights.x * edge1 + weights.y * edge2;
  EmitterPoint point;
  point.path = target - from;
  RaySurface surface = raySurfaces[floatBitsToInt(emitter.B.w)];
  float occlusion;
  point.emission = rayMaterial(surface, floatBitsToInt(emitter.C.w), weights,
    dot(across, point.path) < 0.0, occlusion).Emission.rgb;
  point.perArea = surface.Emission.w;
  point.density = emitterDensity(point.perArea, from, target, normalize(across));
  return point;
}
