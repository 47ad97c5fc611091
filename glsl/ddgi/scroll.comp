#version 430 core
// Resets the probes that enter a grid when it scrolls. Until their first update the coarser grids are used in their
// place. That update already contains the light of all bounces, from the probes around. Variants: those of
// probes/field.glsl.
#include "lib/octahedral.glsl"
#include "ddgi/field.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

layout(rgba32f, binding = 0) uniform writeonly image2D probes;
layout(rg32f, binding = 3) uniform writeonly image2D distances;
layout(rgba32f, binding = 4) uniform writeonly image2D places;

uniform int number;  // index of the grid
uniform ivec3 moved; // movement in cells

#include "ddgi/see_nothing.glsl"

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
  fieldSeeNothing(probe);
  setProbeState(probe, ProbeState(0.0, 0.0, 1.0));
}
