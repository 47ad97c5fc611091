// Into a mapper's fragment shader (GLSL 1.50). The layout of the G-buffer:
//   0 albedo:   rgb diffuse reflectance, a coverage; the outputs 0, 2 and 4 may be blended by it
//   1 normal:   xy octahedral normal in view coordinates, z material / 65535, w roughness
//   2 ambient:  rgb radiance reflected from ambient light or surroundings; of a surface that is
//               shown as drawn, its colour
// and, where the scene holds textures or PBR (GI_EXTENDED):
//   3 surface:  Phong: rgb the texture's factor on specular light; PBR: r metallic, g occlusion
//   4 emission: rgb radiance given off
uniform int giMaterial;
uniform int giBackMaterial;
#include "lib/octahedral.glsl"
