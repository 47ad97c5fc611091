// Into a mapper's fragment shader (GLSL 1.50). The layout of the G-buffer:
//   0 albedo:   rgb diffuse reflectance, a coverage
//   1 normal:   xy octahedral normal in view coordinates, z material / 65535
//   2 ambient:  rgb radiance reflected from ambient light or surroundings; of a surface that is
//               shown as drawn, its colour. a: where nothing is blended, 0: in frames in which
//               no surface has any of this, the target starts resource::Irradiance
// and, where the scene holds textures or PBR (GI_EXTENDED):
//   3 surface:  Phong: rgb the texture's factor on specular light; PBR: r metallic, g occlusion,
//               b roughness
//   4 emission: rgb radiance given off
// and, where a technique asks for it, in this order (the targets' numbers are filled in, see
// CaptureOutputs.h):
//   surroundings: rgb the part of the ambient radiance that highlights reflect of the environment
//   displacement: xyz how far the point was from here one frame ago, within its prop, but in view
//               coordinates
//   facet:      xy octahedral normal of the flat piece of surface in view coordinates, z by how much the
//               round surface that the shading normals stand for is above it, by giEncodeHeight
// Where fragments may cover a pixel in part, all of them are blended by their alpha.
// An interpolated alpha of one may come out a rounding less: what eight bits cannot tell from one
// is one.
const float giOpaque = 254.5 / 255.0;
#ifdef GI_DISPLACEMENT
#ifdef GI_DEFORMS
in vec3 giDisplacement;
#else
const vec3 giDisplacement = vec3(0.0);
#endif
#endif
uniform int giMaterial;
uniform int giBackMaterial;
uniform float giAmbientAlpha;
uniform int giMendsNormals;
#include "lib/octahedral.glsl"
#include "lib/height.glsl"
#include "capture/coverage.glsl"
