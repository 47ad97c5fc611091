#version 430 core
// Initializes probes that move. Until its next update such a probe has the light of its witness, as it lights the
// surfaces that its own rays hit, and it lights a point only if no other probe sees it. This is a separate pass, as
// relocate.comp compares the light of neighbours.
#include "lib/octahedral.glsl"
#include "ddgi/field.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

layout(rgba32f, binding = 0) uniform readonly image2D places;
layout(rgba32f, binding = 1) uniform image2D map; // irradiance, see ddgi/field.glsl

layout(rg32f, binding = 3) uniform image2D distances;

uniform int probeCount;

#include "ddgi/see_nothing.glsl"

// Keeps the distance map of the grid point that a probe leaves.
void keepGridPointDistances(int probe)
{
  const int side = GI_FIELD_DISTANCE + 2;
  for (int i = 0; i < side * side; ++i)
  {
    ivec2 texel = ivec2(i % side, i / side);
    vec4 distance = imageLoad(distances, fieldTile(probe) * side + texel);
    imageStore(distances, fieldTile(fieldGridPointMap(probe)) * side + texel, distance);
  }
}

void copyLight(int toMap, int fromMap)
{
  const int side = GI_FIELD_LIGHT + 2;
  ivec2 to = fieldTile(toMap) * side;
  ivec2 from = fieldTile(fromMap) * side;
  for (int i = 0; i < side * side; ++i)
  {
    ivec2 texel = ivec2(i % side, i / side);
    imageStore(map, to + texel, imageLoad(map, from + texel));
  }
}

void main()
{
  int probe = int(gl_GlobalInvocationID.x);
  if (probe >= probeCount)
  {
    return;
  }
  int moves = int(imageLoad(places, fieldTile(probe)).w); // see ddgi/relocate.comp
  if (moves == 0)
  {
    return;
  }
  if (texelFetch(fieldProbes, fieldTile(probe), 0).xyz == vec3(0.0))
  {
    keepGridPointDistances(probe);
  }
  fieldSeeNothing(probe);
  if (moves < 0)
  {
    return;
  }
  // A witness is lit and stays in place, so no invocation writes to its map.
  copyLight(probe, moves - 1);
  copyLight(fieldEmittedMap(probe), fieldEmittedMap(moves - 1));
  ProbeState state = probeState(probe);
  state.lights = 2.0;
  setProbeState(probe, state);
}
