#version 430 core
// Probes of a grid that moved, where the grid had none before. Until its rays know better such a probe has the light of
// those of the grids around that it sees, and is asked only where no other sees a point. Variants: those of
// probes/field.glsl and rays/passage.glsl.
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "ddgi/field.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

layout(rgba32f, binding = 0) uniform image2D probes;
layout(rgba32f, binding = 1) uniform image2D map; // of light
layout(rg32f, binding = 3) uniform writeonly image2D distances;
layout(rgba32f, binding = 4) uniform writeonly image2D places;

uniform int number;  // of the grid
uniform ivec3 moved; // by so many cells

const int LIGHT_SIDE = GI_FIELD_LIGHT + 2;

#include "ddgi/see_nothing.glsl"

void addLight(ivec2 tile, float share, int other)
{
  for (int i = 0; i < LIGHT_SIDE * LIGHT_SIDE; ++i)
  {
    ivec2 texel = ivec2(i % LIGHT_SIDE, i / LIGHT_SIDE);
    vec4 light = share * texelFetch(fieldLight, fieldTile(other) * LIGHT_SIDE + texel, 0);
    imageStore(map, tile * LIGHT_SIDE + texel, imageLoad(map, tile * LIGHT_SIDE + texel) + light);
  }
}

void takeLightOfGridsAround(int probe, vec3 place)
{
  ivec2 tile = fieldTile(probe);
  for (int i = 0; i < LIGHT_SIDE * LIGHT_SIDE; ++i)
  {
    imageStore(map, tile * LIGHT_SIDE + ivec2(i % LIGHT_SIDE, i / LIGHT_SIDE), vec4(0.0));
  }
  uint state = giHash(uint(probe));
  for (fieldWalk walk = fieldWalkFrom(number - 1); fieldStep(walk, place);)
  {
    int others[8];
    float weights[8];
    fieldWeights(walk, place, vec3(0.0), vec3(0.0), 0.0, false, others, weights);
    float seen = 0.0;
    for (int i = 0; i < 8; ++i)
    {
      Ray ray = Ray(place, 0.0, fieldPosition(walk.grid, others[i]) - place, 1.0);
      weights[i] = blocked(ray, state) ? 0.0 : weights[i];
      seen += weights[i];
    }
    for (int i = 0; i < 8; ++i)
    {
      if (weights[i] > 0.0)
      {
        addLight(tile, walk.share * weights[i] / seen, others[i]);
      }
    }
  }
}

void main()
{
  fieldGrid grid = fieldGridOf(number);
  int probe = grid.first + int(gl_GlobalInvocationID.x);
  if (probe >= fieldBegins[number + 1])
  {
    return;
  }
  ivec3 before = fieldCell(grid, probe) + moved;
  if (all(greaterThanEqual(before, ivec3(0))) && all(lessThan(before, grid.counts)))
  {
    return;
  }
  ivec2 tile = fieldTile(probe);
  imageStore(probes, tile, vec4(0.0));
  imageStore(places, tile, vec4(0.0));
  takeLightOfGridsAround(probe, fieldHome(grid, probe));
  fieldSeeNothing(probe);
  setProbeState(probe, ProbeState(2.0, 0.0, 1.0));
}
