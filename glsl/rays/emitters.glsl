// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples points of the surfaces that emit light, by power and distance. Needs rays/surface.glsl, lib/sampling.glsl.
uniform int emitterCount;  // triangles
uniform int emitterLevels; // of the tree above them
uniform vec4 emitterCube;  // around them; xyz: lowest corner, w: side

const int EMITTER_CANDIDATES = 2; // points among which one is chosen for a ray
const int EMITTER_LEVELS = 4;     // number of levels that a random number of 24 bits can choose well

RayEmitter emitterRecord(int index)
{
  return RayEmitter(uintBitsToFloat(texelFetch(rayEmitters, 3 * index)), uintBitsToFloat(texelFetch(rayEmitters, 3 * index + 1)),
    uintBitsToFloat(texelFetch(rayEmitters, 3 * index + 2)));
}

// Converts a density per area to one per solid angle. from: where the solid angle is measured; to, normal: the point.
float emitterDensity(float perArea, vec3 from, vec3 to, vec3 normal)
{
  vec3 path = to - from;
  float square = dot(path, path);
  return perArea * square * sqrt(square) / max(abs(dot(normal, path)), 1e-20);
}

// Density per solid angle by which a point of an emitter is weighted against directions that are sampled otherwise. Any
// density is right that both ways agree on. This one is that of a choice by power, but as if each triangle were chosen once in 64
// times at least, as small ones nearby are.
float emitterMisDensity(RaySurface surface, vec3 from, vec3 to, vec3 normal)
{
  float often = intBitsToFloat(surface.Clip.z) / 64.0;
  return emitterDensity(surface.Emission.w > 0.0 ? max(surface.Emission.w, often) : 0.0, from, to, normal);
}

// Approximate light that a node sends to a surface. normal: of the surface, zero for a point in space.
float emitterImportance(vec3 center, float radius, float power, vec3 from, vec3 normal)
{
  vec3 path = center - from;
  float inverse = inversesqrt(max(dot(path, path), max(radius * radius, 1e-30)));
  float facing = dot(normal, normal) > 0.0 ? clamp((dot(normal, path) + radius) * inverse, 0.0, 1.0) : 1.0;
  return power * facing * inverse * inverse;
}

// Chooses an emitter with a probability, which is zero if none sends light. Leaves a random number in u.
int pickEmitter(vec3 from, vec3 normal, inout float u, out float probability, inout uint state)
{
  int node = 0;
  probability = 1.0;
  for (int level = 0; level < emitterLevels; ++level)
  {
    RayEmitter four = emitterRecord(emitterCount + node);
    vec4 importance;
    for (int i = 0; i < 4; ++i)
    {
      vec2 xy = unpackUnorm2x16(floatBitsToUint(four.B[i]));
      vec2 zr = unpackUnorm2x16(floatBitsToUint(four.C[i]));
      vec3 center = emitterCube.xyz + emitterCube.w * vec3(xy, zr.x);
      importance[i] = emitterImportance(center, emitterCube.w * zr.y, four.A[i], from, normal);
    }
    vec3 ends = vec3(importance.x, importance.x + importance.y, importance.x + importance.y + importance.z);
    float sum = ends.z + importance.w;
    float place = u * sum;
    int child = int(dot(vec3(greaterThanEqual(vec3(place), ends)), vec3(1.0)));
    float chosen = child < 2 ? (child == 0 ? importance.x : importance.y) : child == 2 ? importance.z : importance.w;
    float start = child < 2 ? (child == 0 ? 0.0 : ends.x) : child == 2 ? ends.y : ends.z;
    probability = sum > 0.0 ? probability * (chosen / sum) : 0.0;
    u = chosen > 0.0 ? clamp((place - start) / chosen, 0.0, 1.0) : 0.0;
    if (level % EMITTER_LEVELS == EMITTER_LEVELS - 1)
    {
      u = giRandom(state);
    }
    node = 4 * node + 1 + child;
  }
  int leaves = ((1 << 2 * emitterLevels) - 1) / 3; // index of the first leaf
  return min(node - leaves, emitterCount - 1);
}

// A sampled point of an emitter.
struct EmitterPoint
{
  vec3 path;        // from the receiver to the point
  vec3 emission;
  float density;    // per solid angle at the receiver; 0 if no emitter sends light
  float misDensity; // see emitterMisDensity()
  float perArea;    // density of a choice by power alone
};

// normal: of the receiver, whose other side gets no light; zero for a point in space.
EmitterPoint emitterPoint(vec2 u, vec3 from, vec3 normal, inout uint state)
{
  float probability;
  RayEmitter emitter = emitterRecord(pickEmitter(from, normal, u.x, probability, state));
  vec2 weights = giSampleTriangle(u);
  vec3 edge1 = emitter.B.xyz - emitter.A.xyz;
  vec3 edge2 = emitter.C.xyz - emitter.A.xyz;
  vec3 across = cross(edge1, edge2);
  float area = 0.5 * length(across);
  vec3 facing = across / max(2.0 * area, 1e-38);
  vec3 target = emitter.A.xyz + weights.x * edge1 + weights.y * edge2;
  EmitterPoint point;
  point.path = target - from;
  RaySurface surface = raySurfaces[floatBitsToInt(emitter.B.w)];
  float occlusion;
  point.emission = rayMaterial(surface, floatBitsToInt(emitter.C.w), weights, dot(facing, point.path) < 0.0,
    occlusion).Emission.rgb;
  point.density = area > 0.0 ? emitterDensity(probability / area, from, target, facing) : 0.0;
  point.misDensity = emitterMisDensity(surface, from, target, facing);
  point.perArea = surface.Emission.w;
  return point;
}

// One of several candidates, chosen in proportion to the light that each would send if nothing were in its way, for one ray
// to stand for them all (resampling: Talbot, Cline and Egbert 2005, Importance Resampling for Global Illumination).
struct EmitterChoice
{
  vec3 path;
  vec3 light;
  float sum;
  float pick; // random number for the next choice
};

EmitterChoice emitterChoice(inout uint state)
{
  return EmitterChoice(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0, giRandom(state));
}

// Random numbers of a candidate, spread evenly over the emitters and their surfaces.
vec2 emitterCandidate(vec2 u, int number)
{
  return fract(u + float(number) * vec2(1.0 / float(EMITTER_CANDIDATES), 0.618034));
}

// light: what arrives from the candidate, divided by its density.
void emitterConsider(inout EmitterChoice choice, vec3 path, vec3 light)
{
  float weight = dot(light, vec3(1.0));
  weight = weight > 0.0 && weight < 1e38 ? weight : 0.0;
  choice.sum += weight;
  float share = weight > 0.0 ? weight / choice.sum : 0.0;
  bool taken = choice.pick < share;
  choice.path = taken ? path : choice.path;
  choice.light = taken ? light / weight : choice.light;
  choice.pick = taken ? choice.pick / share : (choice.pick - share) / max(1.0 - share, 1e-7);
}

// What arrives from the chosen candidate if nothing is in the way; zero if none was chosen.
vec3 emitterArriving(EmitterChoice choice)
{
  return choice.light * (choice.sum / float(EMITTER_CANDIDATES));
}
