#version 430 core
// Finds which neighbours a probe sees. It stores a bit for thirteen of them; the other thirteen store a bit for this
// probe. Variants: those of rays/passage.glsl.
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "ddgi/field.glsl"

layout(local_size_x = 64) in;

layout(rgba32f, binding = 0) uniform writeonly image2D probes;

uniform int firstProbe;
uniform int lastProbe; // one past it

void main()
{
  int probe = firstProbe + int(gl_GlobalInvocationID.x);
  if (probe >= lastProbe)
  {
    return;
  }
  fieldGrid grid = fieldGridWith(probe);
  ivec3 cell = fieldCell(grid, probe);
  vec3 position = fieldPosition(grid, probe);
  uint state = giHash(uint(probe));
  int seen = 0;
  for (int bit = 0; bit < 13; ++bit)
  {
    ivec3 other = cell + fieldNeighbour(bit);
    if (any(lessThan(other, ivec3(0))) || any(greaterThanEqual(other, grid.counts)))
    {
      continue;
    }
    Ray ray = Ray(position, 0.0, fieldPosition(grid, fieldIndex(grid, other)) - position, 1.0);
    seen |= blocked(ray, state) ? 0 : 1 << bit;
  }
  vec4 before = texelFetch(fieldProbes, fieldTile(probe), 0);
  imageStore(probes, fieldTile(probe), vec4(before.xyz, float(seen)));
}
