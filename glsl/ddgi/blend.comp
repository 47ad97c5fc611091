#version 430 core
// Into a probe's maps goes what its rays found. A group for each probe, an invocation for each row. Variants: GI_BLEND_DISTANCE (the map
// of distances, else that of light).
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "ddgi/field.glsl"
#include "ddgi/directions.glsl"
#include "ddgi/states.glsl"

#ifdef GI_BLEND_DISTANCE
#define TEXELS GI_FIELD_DISTANCE
layout(rg32f, binding = 1) uniform image2D map;
#else
#define TEXELS GI_FIELD_LIGHT
layout(rgba32f, binding = 1) uniform image2D map;
#endif
layout(local_size_x = TEXELS) in;

layout(binding = 0) uniform sampler2D foundTexture; // radiance, distance; a row for each probe

uniform int firstProbe;
uniform int stride; // of the probes whose distances are settled one in so many is blended; 0: none
uniform int rays;
uniform int update;
uniform float least;   // share of this update in the map
uniform float most;    // updates before that count, at most, where they count as many

const float SETTLED = 4.0; // updates of a map since its probe stands where it does

// The border repeats what lies across the fold, so that filters need not know of it.
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
  // A row of texels each: software renderers fetch for every invocation by itself.
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
#else
  float count = state.lights++;
#endif
  // What came earlier weighs less, as it knew fewer bounces: the next of n updates takes the share 2 / (n + 2).
  float share = max(least, 2.0 / (min(count, most) + 2.0));
#ifdef GI_BLEND_DISTANCE
  float farthest = 1.5 * length(fieldGridWith(probe).spacing); // distances beyond it count as this
#endif
  mat3 turn = fieldTurn(probe, update);
  vec3 directions[TEXELS]; // where the rays are not turned yet
  vec4 sums[TEXELS];       // w: weights
  for (int x = 0; x < TEXELS; ++x)
  {
    directions[x] = giDecodeOctahedral((vec2(x, row) + 0.5) / float(TEXELS)) * turn;
    sums[x] = vec4(0.0);
  }
  for (int i = 0; i < rays; ++i)
  {
    vec3 toward = fieldDirection(i);
    vec4 found = texelFetch(foundTexture, ivec2(i, probe), 0);
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
      // A narrow lobe: the 64th power. Of less than this it is as good as nothing, but numbers that are nearly zero take
      // a processor ten times as long.
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
  ivec2 corner = fieldTile(probe) * (TEXELS + 2);
  for (int x = 0; x < TEXELS; ++x)
  {
    ivec2 texel = ivec2(x, row);
    vec4 before = imageLoad(map, corner + 1 + texel);
    vec4 now = sums[x].w > 1e-6 ? sums[x] / sums[x].w : before;
    store(corner, texel, share < 1.0 ? mix(before, now, share) : now);
  }
  barrier(); // until every row has read the state
  if (row == 0)
  {
    setProbeState(probe, state);
  }
}
