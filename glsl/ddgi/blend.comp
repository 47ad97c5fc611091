#version 430 core
// Blends the results of a probe's rays into its map. One group per probe, one invocation per row. Variants:
// GI_BLEND_DISTANCE (the distance map, else the irradiance map), GI_BLEND_EMITTED (the map of irradiance straight from
// emitters; before the irradiance map, as its update does not count).
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "ddgi/field.glsl"
#include "ddgi/directions.glsl"
#include "ddgi/packed_direction.glsl"
#include "ddgi/states.glsl"

#ifdef GI_BLEND_DISTANCE
#define TEXELS GI_FIELD_DISTANCE
layout(rg32f, binding = 1) uniform image2D map;
#else
#define TEXELS GI_FIELD_LIGHT
layout(rgba32f, binding = 1) uniform image2D map;
#endif
// Column of the first ray's result, and the map of a probe.
#if defined(GI_BLEND_EMITTED) && !defined(GI_BLEND_DISTANCE)
#define FIRST_COLUMN (rays + emitterRays)
#define MAP_OF(probe) fieldEmittedMap(probe)
#else
#define FIRST_COLUMN 0
#define MAP_OF(probe) (probe)
#endif
layout(local_size_x = TEXELS) in;

layout(binding = 0) uniform sampler2D foundTexture; // see trace.comp

uniform int firstProbe;
uniform int stride; // one in `stride` probes with settled distances is updated; 0: none
uniform int rays;
#ifdef GI_BLEND_DISTANCE
#define FIRST_RAY 0
#define NEXT_RAY 1
#else
#define FIRST_RAY part
#define NEXT_RAY parts
uniform int emitterRays;
uniform int part; // whose rays are blended
#endif
uniform int update;
uniform float least;   // minimum weight of an update
uniform float most;    // maximum number of earlier updates that count

const float SETTLED = 4.0; // number of updates at a probe's position after which its distance map is settled

// Stores a texel. The border repeats the texels across the fold of the octahedron, so that filtering needs no special
// case.
void store(ivec2 corner, ivec2 texel, vec4 value)
{
  bvec2 first = equal(texel, ivec2(0));
  bvec2 last = equal(texel, ivec2(TEXELS - 1));
  ivec2 across = ivec2(first.x ? 0 : TEXELS + 1, first.y ? 0 : TEXELS + 1);
  bvec2 edge = bvec2(first.x || last.x, first.y || last.y);
  imageStore(map, corner + 1 + texel, value);
  if (edge.x)
  {
    imageStore(map, corner + ivec2(across.x, TEXELS - texel.y), value);
  }
  if (edge.y)
  {
    imageStore(map, corner + ivec2(TEXELS - texel.x, across.y), value);
  }
  if (edge.x && edge.y)
  {
    imageStore(map, corner + TEXELS + 1 - across, value);
  }
}

void main()
{
  // An invocation updates a row of texels, as software renderers share no fetches between invocations.
  int probe = firstProbe + int(gl_WorkGroupID.x);
  int row = int(gl_LocalInvocationID.x);
  ProbeState state = probeState(probe);
  if (probeRests(probe, update, state))
  {
    return;
  }
#ifdef GI_BLEND_DISTANCE
  if (state.distances >= SETTLED && (stride == 0 || (probe + update) % max(stride, 1) != 0))
  {
    return;
  }
  float count = state.distances++;
#elif defined(GI_BLEND_EMITTED)
  float count = state.lights;
#else
  float count = state.lights++;
#endif
  // Earlier updates weigh less, as they contain fewer bounces: after n updates the next one has the weight 2 / (n + 2).
  float updateWeight = max(least, 2.0 / (min(count, most) + 2.0));
#ifdef GI_BLEND_DISTANCE
  float farthest = 1.5 * length(fieldGridWith(probe).spacing); // upper bound of distances
#endif
  mat3 turn = fieldTurn(probe, update);
  vec3 directions[TEXELS]; // in the coordinates of the unrotated rays
  vec4 sums[TEXELS];       // w: sum of weights
  for (int x = 0; x < TEXELS; ++x)
  {
    directions[x] = giDecodeOctahedral((vec2(x, row) + 0.5) / float(TEXELS)) * turn;
    sums[x] = vec4(0.0);
  }
  for (int i = FIRST_RAY; i < rays; i += NEXT_RAY)
  {
    vec3 toward = fieldDirection(i);
    vec4 found = texelFetch(foundTexture, ivec2(FIRST_COLUMN + i, probe), 0);
#ifdef GI_BLEND_DISTANCE
    float distance = min(found.a, farthest);
    found = vec4(distance, distance * distance, 0.0, 1.0);
#else
    found.a = 1.0;
#endif
    for (int x = 0; x < TEXELS; ++x)
    {
      float weight = max(dot(directions[x], toward), 0.0);
#ifdef GI_BLEND_DISTANCE
      // A narrow lobe: the 64th power. Below this cosine it is practically zero, but denormal numbers would take a
      // processor ten times as long.
      weight = weight > 0.4 ? weight : 0.0;
      weight *= weight;
      weight *= weight;
      weight *= weight;
      weight *= weight;
      weight *= weight;
      weight *= weight;
#endif
      sums[x] += weight * found;
    }
  }
  for (int x = 0; x < TEXELS; ++x)
  {
    sums[x] /= max(sums[x].w, 1e-6);
  }
#ifndef GI_BLEND_DISTANCE
  for (int i = rays + part; i < rays + emitterRays; i += parts)
  {
    vec4 found = texelFetch(foundTexture, ivec2(i, probe), 0);
    vec3 toward = fieldUnpackDirection(found.a) * turn;
    for (int x = 0; x < TEXELS; ++x)
    {
      sums[x].rgb += max(dot(directions[x], toward), 0.0) * found.rgb;
    }
  }
#endif
  ivec2 corner = fieldTile(MAP_OF(probe)) * (TEXELS + 2);
  for (int x = 0; x < TEXELS; ++x)
  {
    ivec2 texel = ivec2(x, row);
    vec4 previous = imageLoad(map, corner + 1 + texel);
    vec4 updated = sums[x].w > 0.5 ? sums[x] : previous;
    store(corner, texel, updateWeight < 1.0 ? mix(previous, updated, updateWeight) : updated);
  }
  barrier(); // all rows have read the state
  if (row == 0)
  {
    setProbeState(probe, state);
  }
}
