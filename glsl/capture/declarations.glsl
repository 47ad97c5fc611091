// Into a mapper's fragment shader (GLSL 1.50). The layout of the G-buffer:
//   0 albedo:   rgb diffuse reflectance, a coverage
//   1 normal:   xy octahedral normal in view coordinates, z material / 65535
//   2 ambient:  rgb radiance reflected from ambient light or surroundings; of a surface that is
//               shown as drawn, its colour
// and, where the scene holds textures or PBR (GI_EXTENDED):
//   3 surface:  Phong: rgb the texture's factor on specular light; PBR: r metallic, g occlusion,
//               b roughness
//   4 emission: rgb radiance given off
// and, where a technique asks for it (GI_SURROUNDINGS):
//   5 surroundings: rgb the part of the ambient radiance that highlights reflect of the environment
// Where fragments may cover a pixel in part, all of them are blended by their alpha.
// An interpolated alpha of one may come out a rounding less: what eight bits cannot tell from one
// is one.
const float giOpaque = 254.5 / 255.0;
uniform int giMaterial;
uniform int giBackMaterial;
#include "lib/octahedral.glsl"
