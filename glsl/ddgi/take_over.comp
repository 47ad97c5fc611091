#version 430 core
// Until it knows better, a probe that moves takes the light where it goes from a neighbour there, as it lights what its
// own rays find, and is asked only where no other sees a point. After all have chosen their places, as those look at
// each other's light.
#include "lib/octahedral.glsl"
#include "ddgi/field.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

layout(rgba32f, binding = 0) uniform readonly image2D places;
layout(rgba32f, binding = 1) uniform image2D map; // of light

layout(rg32f, binding = 3) uniform image2D distances;

uniform int probeCount;

#include "ddgi/see_nothing.glsl"

// What is seen from the place that it leaves.
void keepSightOfPlace(int probe)
{
  const int side = GI_FIELD_DISTANCE + 2;
  for (int i = 0; i < side * side; ++i)
  {
    ivec2 texel = ivec2(i % side, i / side);
    vec4 sight = imageLoad(distances, fieldTile(probe) * side + texel);
    imageStore(distances, fieldTile(fieldLeft(probe)) * side + texel, sight);
  }
}

void main()
{
  int probe = int(gl_GlobalInvocationID.x);
  if (probe >= probeCount)
  {
    return;
  }
  int moves = int(imageLoad(places, fieldTile(probe)).w); // as ddgi/relocate.comp says
  if (moves == 0)
  {
    return;
  }
  if (texelFetch(fieldProbes, fieldTile(probe), 0).xyz == vec3(0.0))
  {
    keepSightOfPlace(probe);
  }
  fieldSeeNothing(probe);
  if (moves < 0)
  {
    return;
  }
  // The witness stays where it is, in the light: nobody writes to its map.
  const int side = GI_FIELD_LIGHT + 2;
  ivec2 to = fieldTile(probe) * side;
  ivec2 from = fieldTile(moves - 1) * side;
  for (int i = 0; i < side * side; ++i)
  {
    ivec2 texel = ivec2(i % side, i / side);
    imageStore(map, to + texel, imageLoad(map, from + texel));
  }
  ProbeState state = probeState(probe);
  state.lights = 2.0;
  setProbeState(probe, state);
}
