// Inserted into a mapper's fragment shader (GLSL 1.50). The layout of the G-buffer:
//   0 albedo:   rgb diffuse reflectance, a coverage
//   1 normal:   xy octahedral normal in view coordinates, z material / 65535
//   2 ambient:  rgb radiance reflected from ambient light or from the environment; the colour of a
//               surface that is shown as drawn. Not kept in frames in which no surface has either
// If the scene has textures or PBR (GI_EXTENDED):
//   3 surface:  Phong: rgb the texture's factor on specular light; PBR: r metallic, g occlusion,
//               b roughness
//   4 emission: rgb emitted radiance
// Those of the following that a technique requests, in this order (CaptureOutputs.h assigns the targets' numbers):
//   surroundings: rgb the part of the ambient radiance that highlights reflect from the environment
//   displacement: xyz vector to the point's position in the previous frame, by deformation within the prop alone,
//               in view coordinates
//   facet:      xy octahedral normal of the flat facet in view coordinates, z height of the curved surface that the
//               shading normals represent over the facet, as giEncodeHeight
// Where fragments may cover a pixel partly, all of them are blended by their alpha.
// Smallest alpha that counts as opaque: an interpolated alpha of one may be rounded down, by less than eight bits show.
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
uniform int giMendsNormals;
uniform vec2 giDepthWindow; // depths of the camera's clipping planes, if the projection reaches beyond them
uniform float giReflectance; // factor of all diffuse reflectances and base colours
#include "lib/octahedral.glsl"
#include "lib/compensation.glsl"
#include "lib/height.glsl"
#include "capture/coverage.glsl"
