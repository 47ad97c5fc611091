#version 430 core
// Fits linearly transformed cosines to the highlights of VTK's metallic-roughness model, by the cosine to the eye
// (column) and the roughness (row): Heitz, Dupuy, Hill and Neubelt 2016, "Real-Time Polygonal-Light Shading with
// Linearly Transformed Cosines". Layer 0: the matrix to the cosine's directions, in coordinates whose z is the normal and
// whose x points to the eye, has the rows (1 0 x), (0 y 0), (z 0 w). Layer 1: x, y: factors of f0 and f90 in the
// reflectance.
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "direct_light/highlight_fit.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform writeonly image2DArray table;

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec2 place = vec2(texel) / vec2(imageSize(table).xy - 1);
  vec4 entries[2] = fitHighlight(place);
  imageStore(table, ivec3(texel, 0), entries[0]);
  imageStore(table, ivec3(texel, 1), entries[1]);
}
